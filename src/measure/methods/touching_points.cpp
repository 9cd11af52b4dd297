#include "measure/methods/touching_points.hpp"

#include <algorithm>

#include "methods/perturbed.hpp"
#include "sequence/kept_point.hpp"

namespace manifuzz {
namespace {

void deepest_first(TouchingPoints& said) {
  std::erase_if(said.points, [](const ContactPoint<double>& point) { return !(point.depth >= 0); });
  std::ranges::stable_sort(said.points, std::greater{}, &ContactPoint<double>::depth);
  said.touches = !said.points.empty();
  if (said.touches) said.depth = said.points.front().depth;
}

Pose<double> b_in_a(const PairCase& pair) {
  const auto wide = [](const Pose<float>& pose) {
    return Pose<double>{pose.position.cast<double>(), unit_direction(pose.rotation.cast<double>())};
  };
  return relative_pose(wide(pair.a.pose), wide(pair.b.pose));
}

}  // namespace

Manifold<double> TouchingPoints::ends() const {
  Manifold<double> manifold;
  if (points.empty()) return manifold;
  const Vector2<double> along = counter_clockwise_quarter(normal);
  const auto place = [&](const ContactPoint<double>& point) { return along.dot(point.position); };
  const auto [first, last] = std::ranges::minmax_element(points, {}, place);
  manifold.normal = normal;
  manifold.count = points.size() > 1 ? 2 : 1;
  manifold.points = {*first, *last};
  return manifold;
}

TouchingPoints touching_points(const Answer& answer) {
  TouchingPoints said;
  if (const auto* const whole = std::get_if<Penetration>(&answer)) {
    const Vector2<double> none(0, 0);
    return {true, whole->touches, whole->normal.value_or(none), whole->depth, {}};
  }
  const Manifold<double>* const manifold = manifold_in(answer);
  if (manifold == nullptr) return said;
  said.is_answered = true;
  said.normal = manifold->normal;
  said.points.assign(manifold->points.begin(), manifold->points.begin() + manifold->count);
  deepest_first(said);
  return said;
}

TouchingPoints touching_points(const PairCase& pair, const KeptAnswer& answer) {
  TouchingPoints said;
  const auto* const kept = std::get_if<KeptManifold>(&answer);
  if (kept == nullptr) return said;
  said.is_answered = true;
  double deepest = -1;
  for (const KeptPoint& point : kept->points) {
    said.points.push_back({anchor_b_in_a(pair, point), point.depth, {}});
    if (point.depth <= deepest) continue;
    deepest = point.depth;
    said.normal = local_normal(pair, point.normal);
  }
  deepest_first(said);
  return said;
}

namespace {

/// How many points a clip has; none where rounding may show another number.
std::optional<int> decided_count(const Admissible& right, const exact::Clip& clip) {
  if (may_miss(right, clip) || clip.count < 2) return std::nullopt;
  int count = 0;
  for (const exact::ClipPoint& point : points_of(clip)) {
    if (is_at_zero_depth(right, clip, point)) return std::nullopt;
    count += compare_depth(clip, point, 0) > 0 ? 1 : 0;
  }
  return count;
}

}  // namespace

ClipNow clip_now(const Admissible& right) {
  if (!right.may_touch) return {.is_decided = true, .count = 0};
  if (!right.must_touch || right.candidates.empty()) return {};
  // Faces that are parallel tie; their clips have as many points.
  const auto first = decided_count(right, *right.candidates.front());
  const bool is_decided =
      first && std::ranges::all_of(right.candidates, [&](const exact::Clip* clip) {
        return decided_count(right, *clip) == first;
      });
  return is_decided ? ClipNow{.is_decided = true, .count = *first} : ClipNow{};
}

int lingering_points(const PairCase& pair, const TouchingPoints& said, double bound) {
  if (said.points.empty()) return 0;
  const auto a = polygon_cast<double>(pair.a.polygon);
  const auto b = transform(b_in_a(pair), polygon_cast<double>(pair.b.polygon));
  Manifold<double> along;
  along.normal = said.normal;
  const methods::Alongside<double> seen(a, b, along);
  return static_cast<int>(
      std::ranges::count_if(said.points, [&](const ContactPoint<double>& point) {
        const double place = seen.place(point.position);
        if (place < seen.last(false) - bound || place > seen.last(true) + bound) return true;
        const auto depth = seen.depth_at(place, bound);
        return !depth || *depth < -bound;
      }));
}

}  // namespace manifuzz
