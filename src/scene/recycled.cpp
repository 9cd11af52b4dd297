#include "scene/recycled.hpp"

namespace manifuzz::scene {
namespace {

/// A point of A's frame in the frame of B.
Vector2<float> in_b(const Pose<float>& b_in_a, const Vector2<float>& point) {
  return rotate_back<float>(b_in_a.rotation, point - b_in_a.position);
}

}  // namespace

Manifold<float> recycled(const Manifold<float>& manifold, const Pose<float>& from,
                         const Pose<float>& to) {
  Manifold<float> carried = manifold;
  const Vector2<float> normal_in_b = rotate_back(from.rotation, manifold.normal);
  if (manifold.reference == Side::b) carried.normal = rotate(to.rotation, normal_in_b);
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint<float>& point = carried.points[i];
    const Vector2<float> at = point.position;
    if (manifold.reference == Side::a) {
      point.position = transform(to, in_b(from, at));
      point.depth -= manifold.normal.dot(point.position - at);
    } else {
      point.depth += normal_in_b.dot(in_b(to, at) - in_b(from, at));
    }
  }
  return carried;
}

}  // namespace manifuzz::scene
