#include <algorithm>
#include <array>

#include "oracle/box2d3/floats.hpp"

namespace manifuzz::ledger_of::box2d3 {
namespace {

/// The places of a core's ends along the other, from its first end.
struct Along {
  float from = 0;
  float to = 0;

  bool is_outside(float length) const {
    return (from <= 0 && to <= 0) || (from >= length && to >= length);
  }
};

/// A core's side of the greater separation.
struct BestSide {
  Float2 normal;
  float separation = 0;
};

BestSide best_side(const Float2& axis, const Float2& origin, const Float2& p, const Float2& q) {
  const Float2 normal = counter_clockwise_quarter(axis);
  const float first = (p - origin).dot(normal);
  const float second = (q - origin).dot(normal);
  const float ahead = first < second ? first : second;
  const float behind = -first < -second ? -first : -second;
  if (ahead > behind) return {normal, ahead};
  return {-normal, behind};
}

/// Both ends of a core that is clipped by the other.
std::array<Float2, 2> clipped_core(const Float2& p, const Float2& q, const Along& along,
                                   float length) {
  Float2 from = p;
  Float2 to = q;
  if (along.from < 0 && along.to > 0) {
    from = lerp(p, q, (0.0F - along.from) / (along.to - along.from));
  } else if (along.to < 0 && along.from > 0) {
    to = lerp(q, p, (0.0F - along.to) / (along.from - along.to));
  }
  if (along.from > length && along.to < length) {
    from = lerp(p, q, (along.from - length) / (along.from - along.to));
  } else if (along.to > length && along.from < length) {
    to = lerp(q, p, (along.to - length) / (along.to - along.from));
  }
  return {from, to};
}

}  // namespace

SegmentDistance segment_distance(const Float2& p1, const Float2& q1, const Float2& p2,
                                 const Float2& q2) {
  const Float2 d1 = q1 - p1;
  const Float2 d2 = q2 - p2;
  SegmentDistance found{nearest_shares<float>(p1, d1, p2, d2)};
  found.closest1 = p1 + found.share1 * d1;
  found.closest2 = p2 + found.share2 * d2;
  found.between = found.closest2 - found.closest1;
  found.square = found.between.dot(found.between);
  return found;
}

Found collide_capsules(const Placed& placed) {
  const Float2 p1(0, 0);
  const Float2& q1 = placed.first.vertices[1];
  const Float2& p2 = placed.second.vertices[0];
  const Float2& q2 = placed.second.vertices[1];
  const float radius = placed.radius();
  const SegmentDistance nearest = segment_distance(p1, q1, p2, q2);
  Found found;
  found.is_beyond_range = nearest.is_beyond_range;
  const float most = radius + kSpeculative;
  if (nearest.square > most * most) return found;
  const float distance = std::sqrt(nearest.square);
  const Float2 u1 = normalized(q1 - p1);
  const Float2 u2 = normalized(q2 - p2);
  const float length1 = (q1 - p1).norm();
  const float length2 = (q2 - p2).norm();
  const Along of_second{(p2 - p1).dot(u1), (q2 - p1).dot(u1)};
  const Along of_first{(p1 - p2).dot(u2), (q1 - p2).dot(u2)};
  if (!of_second.is_outside(length1) && !of_first.is_outside(length2)) {
    const BestSide on_first = best_side(u1, p1, p2, q2);
    const BestSide on_second = best_side(u2, p2, p1, q1);
    const bool is_by_first = on_first.separation + kTenth >= on_second.separation;
    const auto ends = is_by_first ? clipped_core(p2, q2, of_second, length1)
                                  : clipped_core(p1, q1, of_first, length2);
    const Float2& out = is_by_first ? on_first.normal : on_second.normal;
    const Float2& origin = is_by_first ? p1 : p2;
    const float of_reference = is_by_first ? placed.first.radius : placed.second.radius;
    const float of_incident = is_by_first ? placed.second.radius : placed.first.radius;
    const std::array gaps{(ends[0] - origin).dot(out), (ends[1] - origin).dot(out)};
    if (std::min(gaps[0], gaps[1]) <= distance + kSlop) {
      found.normal = is_by_first ? out : Float2(-out);
      for (const std::size_t k : {0U, 1U}) {
        found.points.push_back(clipped_point(ends[k], out, gaps[k], of_reference, of_incident));
      }
      found.is_clipped = true;
      return found;
    }
  }
  const bool has_direction = nearest.between.dot(nearest.between) > kEpsilon * kEpsilon;
  found.normal = has_direction ? normalized(nearest.between) : counter_clockwise_quarter(u1);
  found.points = {
      single_point(nearest.closest1, nearest.closest2, found.normal, distance - radius, placed)};
  return found;
}

}  // namespace manifuzz::ledger_of::box2d3
