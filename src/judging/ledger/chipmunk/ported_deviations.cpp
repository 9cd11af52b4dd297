#include <algorithm>
#include <cmath>
#include <optional>

#include "judging/by_curve.hpp"
#include "judging/ledger/chipmunk/munk_replay.hpp"
#include "judging/ledger/round_deviations.hpp"

// What ports have beside what they were ported from: Munk2D and cp of Chipmunk, jbox2d of Box2D.

namespace manifuzz {
namespace {

/// The middle of the box around a core, in world directions seen from A's position.
Vector2<double> middle_of(const exact::RoughPolygon& core) {
  Vector2<double> low = core.vertices[0];
  Vector2<double> high = low;
  for (int i = 1; i < core.count; ++i) {
    low = low.cwiseMin(core.vertices[i]);
    high = high.cwiseMax(core.vertices[i]);
  }
  return 0.5 * (low + high);
}

/// What cp would find if it added no more than Chipmunk does; none where it gave another answer
/// than its operations give.
std::optional<munk::Found> without_what_cp_adds(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const replayed::Contact given =
      munk::contact_of(munk::found_by(munk::kCp, pair), d.got.reference);
  if (!replayed::is_same_answer(d, given)) return std::nullopt;
  return munk::found_by(munk::kChipmunk, pair);
}

/// Whether it would be right, with its points on either edge where the answer had none that says.
bool is_right_by_chipmunk(const Deviation& d, const munk::Found& found) {
  const auto is_right = [&](Side reference) {
    return replayed::is_right_answer(d, as_chipmunk(), munk::contact_of(found, reference));
  };
  return is_right(d.got.reference) || (d.got.count == 0 && is_right(other(d.got.reference)));
}

bool is_wrong_as_chipmunk(const Deviation& d) {
  if (!is_round(d.right.pair())) {
    return normal_of_rounded_vertices(d) || neighbours_nearly_parallel(d);
  }
  return sign_of_swapped_distance(d) || sign_of_polygon_radius(d) ||
         direction_to_place_on_segment(d) || direction_between_corners(d) ||
         segment_normal_not_unit(d) || normal_across_corner_on_corner(d) ||
         normal_across_collinear(d) || depth_by_crossing(d);
}

}  // namespace

bool zero_normal_of_one_middle(const Deviation& d) {
  if (d.got.count == 0 || !d.got.normal.isZero(0)) return false;
  for (int i = 0; i < d.got.count; ++i) {
    if (d.got.points[i].depth != 0) return false;
  }
  const exact::RoughPair placed = exact::place_roughly(d.right.pair());
  return (middle_of(placed.a) - middle_of(placed.b)).norm() <= 4 * d.right.bounds.separation;
}

bool normal_short_by_cp(const Deviation& d) {
  const auto found = without_what_cp_adds(d);
  if (!found) return false;
  if (is_right_by_chipmunk(d, *found)) return true;
  // Beside it something of Chipmunk's may be wrong, which alone is not what was given.
  const replayed::Contact contact = munk::contact_of(*found, d.got.reference);
  const Manifold<double> mended = replayed::in_frame_of_a(d.right.pair(), contact);
  const Kind kind = mended.count == 0 ? Kind::missed_contact : d.kind;
  if (!is_wrong_as_chipmunk({d.right, mended, kind})) return false;
  const bool is_short = d.kind == Kind::normal && d.got.normal.norm() <= 1 - d.right.bounds.normal;
  return is_short || !is_wrong_as_chipmunk(d);
}

bool edge_radius_of_settings(const Deviation& d) {
  constexpr double kRadius = 2 * 0.01F;  // 2.0f * Settings.polygonRadius
  const PairCase& pair = d.right.pair();
  const bool has_edge = std::min(pair.a.polygon.count, pair.b.polygon.count) == 2;
  const bool has_polygon = std::max(pair.a.polygon.count, pair.b.polygon.count) >= kMinVertices;
  if (!has_edge || !has_polygon || d.got.count > 0 || total_radius(pair) <= kRadius) return false;
  const exact::Truth& truth = *d.right.truth;
  return std::max(truth.separation(Side::a), truth.separation(Side::b)) >
         kRadius - 2 * d.right.bounds.separation;
}

}  // namespace manifuzz
