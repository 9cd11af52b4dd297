#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "exact/curve.hpp"
#include "judging/faults/differences.hpp"
#include "oracle/box2d3/faces.hpp"
#include "oracle/box2d3/placed.hpp"

// b2CollideCapsules in double, of Box2D 3 and of phaser-box2d, which has translated it.

namespace manifuzz::ledger_of {

constexpr double kEpsilonOfPhaser = 1e-10;    // math_functions_h.js: eps
constexpr double kSlopOfPhaser = 0.005;       // core_h.js: b2_linearSlop
constexpr double kEpsilonOfBox2d3 = 0x1p-23;  // math_functions.h: FLT_EPSILON

/// A capsule's core, in A's frame, from the first end of A's.
struct Core {
  Vector2<double> from;
  Vector2<double> to;

  Vector2<double> along() const { return to - from; }
  double length() const { return along().norm(); }
  Vector2<double> unit() const { return along() / length(); }
};

/// What b2CollideCapsules finds: `normal` from A to B, in A's frame.
struct FoundByPhaser {
  Vector2<double> normal{0, 0};
  std::vector<double> depths{};  ///< of its points that are no gaps, the deepest first
  bool is_clipped = false;       ///< not the single point between the nearest places
};

/// The normal of a core's side of the greater separation, as the function takes it, and how far the
/// other core is from it: `is_mended` takes the lesser of both ends, as Box2D does.
struct BestSide {
  Vector2<double> normal;
  double separation = 0;
};

inline BestSide best_side(const Core& of, const Core& opposing, bool is_mended) {
  const Vector2<double> unit = of.unit();
  const Vector2<double> normal(-unit.y(), unit.x());
  const double first = (opposing.from - of.from).dot(normal);
  const double second = (opposing.to - of.from).dot(normal);
  const double ahead = std::min(first, second);
  const double behind = is_mended ? std::min(-first, -second) : std::max(-first, -second);
  if (ahead > behind) return {normal, ahead};
  return {-normal, behind};
}

/// The places of a core's ends along the other, from its first end: `is_mended` takes them along
/// it, the function mixes both directions.
struct Places {
  double from = 0;
  double to = 0;

  bool is_outside(double length) const {
    return (from <= 0 && to <= 0) || (from >= length && to >= length);
  }
};

/// Distances from the best side of both ends of a core that is clipped.
inline std::array<double, 2> clipped(const Core& core, const Places& places, double length,
                                     const Vector2<double>& origin, const Vector2<double>& normal) {
  Vector2<double> p = core.from;
  Vector2<double> q = core.to;
  const Vector2<double> along = core.along();
  const double run = places.to - places.from;
  if (places.from < 0 && places.to > 0) p = core.from - places.from / run * along;
  if (places.to < 0 && places.from > 0) q = core.to - places.to / run * along;
  if (places.from > length && places.to < length) {
    p = core.from + (length - places.from) / run * along;
  }
  if (places.to > length && places.from < length) q = core.to + (length - places.to) / run * along;
  return {(p - origin).dot(normal), (q - origin).dot(normal)};
}

/// The vector between both cores where they are nearest, as the function clamps it.
inline Vector2<double> nearest_vector(const Core& a, const Core& b) {
  const auto nearest = box2d3::nearest_shares<double>(a.from, a.along(), b.from, b.along());
  return b.from + nearest.share2 * b.along() - (a.from + nearest.share1 * a.along());
}

inline std::vector<double> depths_of(const std::array<double, 2>& gaps, double radius) {
  std::vector<double> depths;
  for (const double gap : gaps) {
    if (gap <= radius) depths.push_back(radius - gap);
  }
  std::ranges::sort(depths, std::greater());
  return depths;
}

/// What Box2D 3.2 has changed since, of which phaser-box2d is a copy.
struct Edition {
  double bias = 0;                    ///< by which A's side is preferred
  double epsilon = kEpsilonOfPhaser;  ///< up to which a distance has no direction
};

/// b2CollideCapsules, as it stands or with its three slips mended.
inline FoundByPhaser capsules_by_phaser(const Core& a, const Core& b, double radius, bool is_mended,
                                        const Edition& edition = {}) {
  const Vector2<double> apart = nearest_vector(a, b);
  const double distance = apart.norm();
  if (distance > radius + 4 * kSlopOfPhaser) return {};
  const Vector2<double> u1 = a.unit();
  const Vector2<double> u2(is_mended ? b.unit().x() : u1.x(), b.unit().y());
  const Places of_b{(b.from - a.from).dot(u1), (b.to - a.from).dot(u1)};
  const Places of_a{(a.from - b.from).dot(u2), (a.to - b.from).dot(u2)};
  if (!of_b.is_outside(a.length()) && !of_a.is_outside(b.length())) {
    const BestSide on_a = best_side(a, b, is_mended);
    const BestSide on_b = best_side(b, a, is_mended);
    const bool is_by_a = on_a.separation + edition.bias >= on_b.separation;
    const auto gaps = is_by_a ? clipped(b, of_b, a.length(), a.from, on_a.normal)
                              : clipped(a, of_a, b.length(), b.from, on_b.normal);
    if (std::min(gaps[0], gaps[1]) <= distance + kSlopOfPhaser) {
      return {is_by_a ? on_a.normal : Vector2<double>(-on_b.normal), depths_of(gaps, radius), true};
    }
  }
  const Vector2<double> left(-u1.y(), u1.x());
  return {distance > edition.epsilon ? Vector2<double>(apart / distance) : left,
          depths_of({distance, INFINITY}, radius)};
}

/// How far an answer may be from what is found.
struct SlackOfCapsules {
  double depth = 0;
  double normal = 0;
};

/// The operations are the engine's, so only the answer's way through the case's frame rounds it.
inline SlackOfCapsules as_rounded(const Deviation& d) {
  return {d.right.bounds.separation, 4 * d.right.bounds.normal};
}

/// About the same deviation: what a mended slip leaves of it is no slip's.
inline SlackOfCapsules as_about(const Deviation& d) {
  return {1e-9 * (d.right.truth->extent() + total_radius(d.right.pair())), 1e-6};
}

inline bool is_given(const Deviation& d, const FoundByPhaser& found, const SlackOfCapsules& slack) {
  const std::vector<double> depths = sorted_depths(d.got);
  if (depths.size() != found.depths.size()) return false;
  if (depths.empty()) return true;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (std::abs(depths[i] - found.depths[i]) > slack.depth) return false;
  }
  return (d.got.normal.normalized() - found.normal).norm() <= slack.normal;
}

/// Whether the normal of a circle that is as near as that has no length, and the answer is that
/// deep.
inline bool has_no_normal_within(const Deviation& d, double epsilon, double depth) {
  const PairCase& pair = d.right.pair();
  if (d.got.count != 1 || (pair.a.polygon.count != 1 && pair.b.polygon.count != 1)) return false;
  const double bound = epsilon + 4 * d.right.bounds.separation;
  return d.got.normal.norm() <= epsilon &&
         total_radius(pair) - ledger_of::least_depth(d) <= bound &&
         std::abs(d.got.points[0].depth - depth) <= bound;
}

inline std::optional<std::array<Core, 2>> capsule_cores(const PairCase& pair) {
  if (pair.a.polygon.count != 2 || pair.b.polygon.count != 2) return std::nullopt;
  const PlacedByPhaser placed = placed_by_phaser(pair);
  const auto core = [](const exact::RoughPolygon& of) {
    return Core{of.vertices[0], of.vertices[1]};
  };
  return std::array{core(placed.first), core(placed.second)};
}

/// Cores are nearest at a vertex of each, and of the clip of their edges one point is given.
inline bool one_point_between_corners(const Deviation& d) {
  const exact::PenetrationCurve curve(*d.right.truth, exact::Skin::round);
  return d.kind == Kind::count && d.got.count == 1 && is_round(d.right.pair()) &&
         curve.are_cores_apart() && curve.nearest_vertices().has_value();
}

}  // namespace manifuzz::ledger_of
