// The clipping alone, behind somebody's own separation search.

#include <cstdio>
#include <manifuzz/clipping/collide.hpp>
#include <manifuzz/version.hpp>

using namespace manifuzz;

static_assert(MANIFUZZ_VERSION_MAJOR == 0 && MANIFUZZ_VERSION_MINOR >= 1);

template <class Scalar>
void show() {
  const Vector2<Scalar> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto a = make_polygon<Scalar>(corners);
  const auto b = make_polygon<Scalar>(corners, Scalar(0.125));
  const Pose<Scalar> b_in_a{{Scalar(1.75), Scalar(0.5)}, {1, 0}};
  const Vector2<Scalar> normal{1, 0};  // by your SAT, GJK or EPA: from A to B, in A's frame
  const Manifold<Scalar> m = clipping::manifold_from_normal(a, b, b_in_a, normal);
  for (int i = 0; i < m.count; ++i) {
    const auto& [position, depth, features] = m.points[i];
    std::printf("%g %g depth %g ", static_cast<double>(position.x()),
                static_cast<double>(position.y()), static_cast<double>(depth));
  }
  std::puts(m == clipping::collide(a, b, b_in_a) ? "as collide" : "not as collide");
}

int main() {
  show<float>();
  show<double>();
  std::printf("version %s\n", kVersion);
}
