// One pair: what README.md shows of the library.

#include <cstdio>
#include <manifuzz/kernel/pair.hpp>

using namespace manifuzz;

int main() {
  const Vector2<float> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto box = kernel::rows_of(make_polygon<float>(corners));
  const Pose<float> pose_a{{0, 0}, {1, 0}};
  const Pose<float> pose_b{{0.5F, 1.75F}, {1, 0}};
  const Manifold<float> m = kernel::collide(box, box, relative_pose(pose_a, pose_b));
  for (int i = 0; i < m.count; ++i) {
    const auto at = transform(pose_a, m.points[i].position);  // manifolds are in A's frame
    std::printf("%g deep at (%g, %g)\n", m.points[i].depth, at.x(), at.y());
  }
}
