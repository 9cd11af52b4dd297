#include "oracle/phaser-box2d/polygons.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "exact/curve.hpp"
#include "oracle/box2d3/faces.hpp"
#include "oracle/box2d3/placed.hpp"

// phaser-box2d's b2CollidePolygons on round shapes.

namespace manifuzz {
namespace {

using exact::RoughPolygon;
namespace box2d3 = ledger_of::box2d3;
using box2d3::best_face;
using box2d3::most_opposed;

constexpr double kSlopOfPolygons = 0.1 * 0.005;  // manifold_c.js: 0.1 * b2_linearSlop
constexpr double kEpsilonOfClips = 1e-10;        // math_functions_h.js: eps

/// The error of the numerator of b2SegmentDistance's share, over both lengths and the extent: some
/// 16 roundings of half an ulp.
constexpr double kErrorOfShare = 0x1p-49;

/// Where two edges are nearest, and how far off these places may be.
struct NearestPlaces : box2d3::NearestShares<double> {
  double distance = 0;
  double length1 = 0;
  double sine = 0;  ///< of the angle between both edges

  /// How much too far apart the places may be: the share's division by the square of the sine moves
  /// them along an edge, no farther than it is long, and off the other by the sine of that.
  double excess(double extent) const {
    return sine > 0 ? std::min(length1 * sine, kErrorOfShare * extent / sine) : 0;
  }
};

NearestPlaces nearest_places(const Vector2<double>& p1, const Vector2<double>& q1,
                             const Vector2<double>& p2, const Vector2<double>& q2) {
  const Vector2<double> d1 = q1 - p1;
  const Vector2<double> d2 = q2 - p2;
  NearestPlaces places{box2d3::nearest_shares<double>(p1, d1, p2, d2)};
  places.distance = ((p1 + places.share1 * d1) - (p2 + places.share2 * d2)).norm();
  places.length1 = d1.norm();
  places.sine = std::abs(cross(d1, d2)) / (d1.norm() * d2.norm());
  return places;
}

/// What b2CollidePolygons finds, its normal from A to B in the world.
struct PolygonsByPhaser {
  Vector2<double> normal{0, 0};
  std::vector<double> depths{};  ///< of its points that are no gaps, the deepest first
  NearestPlaces places{};        ///< of both edges
  bool is_between_corners = false;
  bool is_within_slop = false;  ///< clipped because no face is farther than the slop
};

/// The gaps that b2ClipPolygons leaves.
std::array<double, 2> gaps_of_clip(const RoughPolygon& on, int reference, const RoughPolygon& of,
                                   int incident) {
  const Vector2<double>& out = on.normals[reference];
  const Vector2<double> along(-out.y(), out.x());
  const Vector2<double>& corner = on.vertices[reference];
  const double end = (on.vertices[on.next(reference)] - corner).dot(along);
  const Vector2<double>& upper = of.vertices[incident];
  const Vector2<double>& lower = of.vertices[of.next(incident)];
  const double high = (upper - corner).dot(along);
  const double low = (lower - corner).dot(along);
  const bool is_long = high - low > kEpsilonOfClips;
  const auto gap_at = [&](double share) {
    return ((1 - share) * lower + share * upper - corner).dot(out);
  };
  return {low < 0 && is_long ? gap_at(-low / (high - low)) : (lower - corner).dot(out),
          high > end && is_long ? gap_at((end - low) / (high - low)) : (upper - corner).dot(out)};
}

void keep(PolygonsByPhaser& found, double gap, double radius) {
  if (gap <= radius) found.depths.push_back(radius - gap);
  std::ranges::sort(found.depths, std::greater());
}

std::optional<PolygonsByPhaser> polygons_by_phaser(const PairCase& pair) {
  const int fewest = std::min(pair.a.polygon.count, pair.b.polygon.count);
  if (!is_round(pair) || fewest < 2 || pair.a.polygon.count + pair.b.polygon.count < 5) {
    return std::nullopt;
  }
  const PlacedByPhaser placed = placed_by_phaser(pair);
  const RoughPolygon& a = placed.first;
  const RoughPolygon& b = placed.second;
  const double radius = total_radius(pair);
  const auto on_a = best_face<double>(a, b);
  const auto on_b = best_face<double>(b, a);
  const bool is_by_a = on_a.separation >= on_b.separation;
  const int i = is_by_a ? on_a.index : most_opposed(a, b.normals[on_b.index]);
  const int j = is_by_a ? most_opposed(b, a.normals[on_a.index]) : on_b.index;
  PolygonsByPhaser found;
  found.is_within_slop = std::max(on_a.separation, on_b.separation) <= kSlopOfPolygons;
  const NearestPlaces places =
      nearest_places(a.vertices[i], a.vertices[a.next(i)], b.vertices[j], b.vertices[b.next(j)]);
  found.places = places;
  found.is_between_corners = !found.is_within_slop && places.are_ends();
  if (found.is_between_corners) {
    const Vector2<double>& from = a.vertices[places.share1 == 0 ? i : a.next(i)];
    const Vector2<double>& to = b.vertices[places.share2 == 0 ? j : b.next(j)];
    found.normal = 1.0 / places.distance * (to - from);
    keep(found, places.distance, radius);
  } else {
    found.normal = is_by_a ? a.normals[i] : Vector2<double>(-b.normals[j]);
    const auto gaps = is_by_a ? gaps_of_clip(a, i, b, j) : gaps_of_clip(b, j, a, i);
    for (const double gap : gaps) keep(found, gap, radius);
  }
  found.normal = rotate<double>(placed.rotation, found.normal);
  if (placed.is_swapped) found.normal = -found.normal;
  return found;
}

/// Whether that is the answer, within the bounds of numbers that were computed alike.
bool is_answer(const Deviation& d, const PolygonsByPhaser& found) {
  const Bounds& bounds = d.right.bounds;
  const std::vector<double> depths = sorted_depths(d.got);
  const auto is_same = [&](double p, double q) { return std::abs(p - q) <= bounds.separation; };
  if (!std::ranges::equal(depths, found.depths, is_same)) return false;
  if (depths.empty()) return true;
  const Vector2<double> normal =
      rotate<double>(unit_rotation(d.right.pair().a.pose).unit, d.got.normal);
  return (normal - found.normal).norm() <= 4 * bounds.normal;
}

}  // namespace

bool face_within_phaser_slop(const Deviation& d) {
  const auto found = polygons_by_phaser(d.right.pair());
  if (!found || !found->is_within_slop || !is_answer(d, *found)) return false;
  const exact::PenetrationCurve curve(*d.right.truth, exact::Skin::round);
  return curve.are_cores_apart() && curve.nearest_vertices().has_value();
}

bool normal_over_rounded_distance(const Deviation& d) {
  const auto found = polygons_by_phaser(d.right.pair());
  return found && found->is_between_corners && is_answer(d, *found) &&
         std::abs(d.got.normal.norm() - 1) > d.right.bounds.normal;
}

bool nearest_by_phaser_roundings(const Deviation& d) {
  const auto found = polygons_by_phaser(d.right.pair());
  if (!found || found->is_within_slop || !is_answer(d, *found)) return false;
  const exact::PenetrationCurve curve(*d.right.truth, exact::Skin::round);
  const double distance = total_radius(d.right.pair()) - curve.least();
  return curve.are_cores_apart() &&
         found->is_between_corners != curve.nearest_vertices().has_value() &&
         std::abs(found->places.distance - distance) <=
             2 * d.right.bounds.separation + found->places.excess(d.right.truth->extent());
}

}  // namespace manifuzz
