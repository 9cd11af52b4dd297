#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/curve.hpp"
#include "exact/placed.hpp"
#include "judging/faults/differences.hpp"
#include "judging/ledger.hpp"

namespace manifuzz::ledger_of {

/// In the order in which cpCollide takes shapes: circles, segments, polygons.
inline int order_of(const Body& body) {
  return std::min(body.polygon.count, 3);
}

inline bool is_swapped(const PairCase& pair) {
  return order_of(pair.a) > order_of(pair.b);
}

/// Both cores along a normal.
class SeenAlong {
 public:
  /// `normal` in A's frame.
  SeenAlong(const PairCase& pair, const Vector2<double>& normal)
      : placed_(exact::place_roughly(pair)),
        turn_(pair.a.pose.rotation.cast<double>()),
        normal_(rotate<double>(turn_, normal).normalized()),
        tangent_(-normal_.y(), normal_.x()),
        radius_(total_radius(pair)) {}

  const Vector2<double>& normal() const { return normal_; }
  /// How deep both overlap on the line through a point of A's frame, or the nearest that meets
  /// both.
  double depth_at(const Vector2<double>& local, double bound) const {
    const double place = rotate<double>(turn_, local).dot(tangent_);
    double most = -INFINITY;
    for (const double near : {place - bound, place, place + bound}) {
      most = std::max(most, highest(placed_.a, normal_, near) +
                                highest(placed_.b, Vector2<double>(-normal_), near));
    }
    return most + radius_;
  }
  /// How much higher one end of each core's support edges is than the other, and how far both are
  /// apart along the tangent.
  struct Slope {
    double rise = 0;
    double run = 0;
  };
  std::vector<Slope> slopes(Side side, double bound) const {
    const exact::RoughPolygon& core = placed_[side];
    const Vector2<double> out = side == Side::a ? normal_ : Vector2<double>(-normal_);
    double most = -INFINITY;
    for (int i = 0; i < core.count; ++i) most = std::max(most, out.dot(core.vertices[i]));
    std::vector<Slope> found;
    for (int i = 0; i < core.face_count(); ++i) {
      const Vector2<double>& from = core.vertices[i];
      const Vector2<double>& to = core.vertices[core.next(i)];
      if (std::max(out.dot(from), out.dot(to)) < most - bound) continue;
      found.push_back({std::abs(out.dot(to - from)), std::abs(tangent_.dot(to - from))});
    }
    return found;
  }

 private:
  double highest(const exact::RoughPolygon& core, const Vector2<double>& out, double place) const {
    double low = INFINITY;
    double high = -INFINITY;
    for (int i = 0; i < core.count; ++i) {
      low = std::min(low, tangent_.dot(core.vertices[i]));
      high = std::max(high, tangent_.dot(core.vertices[i]));
    }
    const double at = std::clamp(place, low, high);
    double most = -INFINITY;
    for (int i = 0; i < core.count; ++i) {
      const Vector2<double>& from = core.vertices[i];
      const Vector2<double>& to = core.vertices[core.next(i)];
      const double begin = tangent_.dot(from);
      const double run = tangent_.dot(to) - begin;
      if (at < std::min(begin, begin + run) || at > std::max(begin, begin + run)) continue;
      const double share = run == 0 ? 0 : std::clamp((at - begin) / run, 0.0, 1.0);
      most = std::max(most, out.dot(from) + share * out.dot(to - from));
      if (run == 0) most = std::max(most, out.dot(to));
    }
    return most;
  }

  exact::RoughPair placed_;
  Vector2<double> turn_;
  Vector2<double> normal_;
  Vector2<double> tangent_;
  double radius_;
};

inline bool is_without_depth(const Manifold<double>& manifold) {
  return std::all_of(manifold.points.begin(), manifold.points.begin() + manifold.count,
                     [](const ContactPoint<double>& point) { return point.depth == 0; });
}

/// Whether no point is deeper than both cores overlap along the answer's normal.
inline bool is_as_deep_as_there(const Deviation& d) {
  if (d.got.normal.isZero(0)) return is_without_depth(d.got);
  const exact::Along along(*d.right.truth, d.got.normal);
  return std::max(deepest(d.got), 0.0) <= along.depth() + 4 * d.right.bounds.separation;
}

}  // namespace manifuzz::ledger_of
