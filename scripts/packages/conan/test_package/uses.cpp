#include <cstdio>
#include <manifuzz/kernel/pair.hpp>
#include <manifuzz/version.hpp>

using namespace manifuzz;

int main() {
  const Vector2<float> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto box = kernel::rows_of(make_polygon<float>(corners));
  const Manifold<float> manifold = kernel::collide(box, box, {{1.5F, 0}, {1, 0}});
  std::printf("manifuzz %s: %d contact points\n", kVersion, manifold.count);
  return manifold.count == 2 ? 0 : 1;
}
