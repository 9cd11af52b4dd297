#include "oracle/bullet/ledger/manifold.hpp"

// btManifoldResult.cpp and btPersistentManifold.cpp.

namespace manifuzz::ledger_of {

void BulletManifold::add(const Space& normal, const Space& on_b, float distance, int query) {
  if (distance > breaking_) return;
  BulletPoint point;
  point.on_a = on_b + normal * distance;
  point.on_b = on_b;
  point.local_a = pair_->place_a.to_local(Space(point.on_a - pair_->place_a.origin));
  point.local_b = pair_->place_b.to_local(Space(on_b - pair_->place_b.origin));
  point.normal = normal;
  point.distance = distance;
  point.query = query;
  // One and three queries give no more points than the four that it holds.
  const auto near = near_to(point);
  if (near == points.end()) {
    points.push_back(point);
  } else {
    *near = point;
  }
}

std::vector<BulletPoint>::iterator BulletManifold::near_to(const BulletPoint& point) {
  float least = breaking_ * breaking_;
  auto nearest = points.end();
  if (!does_replace_) return nearest;
  for (auto one = points.begin(); one != points.end(); ++one) {
    const float square = squared(Space(one->local_a - point.local_a));
    if (!(square < least)) continue;
    least = square;
    nearest = one;
  }
  return nearest;
}

bool BulletManifold::is_broken(const BulletPoint& point) const {
  if (!(point.distance <= breaking_)) return true;
  const Space projected = point.on_a - point.normal * point.distance;
  return squared(Space(point.on_b - projected)) > breaking_ * breaking_;
}

void BulletManifold::refresh() {
  for (BulletPoint& point : points) {
    point.on_a = pair_->place_a.to_world(point.local_a);
    point.on_b = pair_->place_b.to_world(point.local_b);
    point.distance = dot(Space(point.on_a - point.on_b), point.normal);
  }
  for (std::size_t i = points.size(); i-- > 0;) {
    if (!is_broken(points[i])) continue;
    points[i] = points.back();
    points.pop_back();
  }
}

const BulletPoint* deepest_of(const std::vector<BulletPoint>& points) {
  const BulletPoint* deepest = nullptr;
  for (const BulletPoint& point : points) {
    if (point.distance > 0 || (deepest != nullptr && !(point.distance < deepest->distance))) {
      continue;
    }
    deepest = &point;
  }
  return deepest;
}

}  // namespace manifuzz::ledger_of
