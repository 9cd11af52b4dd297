#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/curve.hpp"
#include "judging/faults/differences.hpp"
#include "judging/faults/replayed.hpp"
#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/bullet/ledger/repeated_query.hpp"
#include "oracle/bullet/ledger/rows.hpp"

// Bullet's query is repeated in its own floats: the answer is what the repeated query gives, and
// that came about by the named rule.

namespace manifuzz {
namespace {

using ledger_of::BulletAnswer;
using ledger_of::BulletAsked;
using ledger_of::BulletEpaEnd;
using ledger_of::NormalOf;
using ledger_of::QueryEnd;
using ledger_of::RepeatedQuery;

/// What a repeated query that gave the answer came about by.
using CameAbout = bool (*)(const Deviation& deviation, const RepeatedQuery& query);

template <BulletAsked kAsked, CameAbout kCameAbout>
bool repeated(const Deviation& d) {
  const RepeatedQuery query = ledger_of::repeat_query(d.right.pair(), kAsked);
  return kCameAbout(d, query) && ledger_of::is_answered(d, query);
}

bool of_any_normal(const Deviation& /*d*/, const RepeatedQuery& /*query*/) {
  return true;
}

bool of_solver(const Deviation& /*d*/, const RepeatedQuery& query) {
  return query.answer.normal_of == NormalOf::solver && !query.answer.is_axis_deeper;
}

/// What another predicate looks for, where the repeated query gave the answer so.
template <BulletAsked kAsked, bool (*kExplains)(const Deviation&),
          CameAbout kCameAbout = of_any_normal>
bool explained_of(const Deviation& d) {
  return kExplains(d) && repeated<kAsked, kCameAbout>(d);
}

bool of_own_axis(const Deviation& /*d*/, const RepeatedQuery& query) {
  return query.answer.is_axis_deeper || query.answer.normal_of == NormalOf::query;
}

/// btGjkPairDetector keeps its own query's axis though that ended below 0.001, the root of
/// REL_ERROR2, or takes it back from the depth solver: its direction is the roundings'.
bool axis_of_touching_cores(const Deviation& d, const RepeatedQuery& query) {
  return of_own_axis(d, query) && query.answer.loop.end == QueryEnd::at_origin;
}

/// The loop whose distance decides ended at a corner that is another than the simplex holds, within
/// VORONOI_DEFAULT_EQUAL_VERTEX_THRESHOLD.
bool stopped_at_near_corner(const Deviation& /*d*/, const RepeatedQuery& query) {
  return query.deciding().is_by_threshold;
}

/// It ended at a corner that its simplex holds, though that is nearer than the closest point said
/// to be the simplex's: roundings of squares and of products of squares decide which it is.
bool stopped_at_rounded_point(const Deviation& /*d*/, const RepeatedQuery& query) {
  return query.deciding().is_closest_rounded;
}

/// Where no corner is nearer along the axis p than p, but for the share e of its square, p is from
/// the nearest place q by |p - q|^2 <= |p|^2 - p . q <= e |p|^2.
bool is_within_relative_error(const Deviation& d) {
  constexpr double share = 1e-6;  // REL_ERROR2
  const Vector2<double> normal = world_normal(d.right.pair(), d.got.normal);
  const Vector2<double> least = replayed::least_normal_near(d, normal);
  return (normal - least).norm() <= std::sqrt(share) + d.right.bounds.normal;
}

/// It ended though corners were left, since the squared distance fell by less than REL_ERROR2 of
/// it, or by no more than a rounding, or would have fallen by less with the corner that roundings
/// of products hid; a normal is off by no more than the root of that.
bool stopped_by_relative_error(const Deviation& d, const RepeatedQuery& query) {
  const QueryEnd end = query.deciding().end;
  const bool is_of_rounded_corner =
      query.answer.normal_of == NormalOf::query &&
      is_nearest_corner_rounded(d.right.pair(), query.asked, query.answer.loop);
  if (end == QueryEnd::no_closer || is_of_rounded_corner) {
    return d.kind == Kind::normal && is_within_relative_error(d);
  }
  return end == QueryEnd::little_closer || end == QueryEnd::no_less;
}

/// It ended at four corners that pointOutsideOfPlane takes for coplanar, or at a closest point of
/// negative weights.
bool stopped_at_flat_simplex(const Deviation& /*d*/, const RepeatedQuery& query) {
  return query.deciding().end == QueryEnd::degenerate;
}

/// The solver's normal and depth with a point of the displaced query, whose own normal is another.
bool point_of_displaced_query(const Deviation& d, const RepeatedQuery& query) {
  constexpr float roundings = 4 * std::numeric_limits<float>::epsilon();
  const ledger_of::Space& beside = query.directions.beside.normal;
  return ledger_of::is_of_points(d.kind) && of_solver(d, query) &&
         (beside - query.directions.direction.normalized()).norm() > roundings;
}

/// The axis of its own query, wherever that ended, took the place of the solver's normal, since
/// they are less deep along it: d2 > d0.
bool axis_taken_back(const Deviation& /*d*/, const RepeatedQuery& query) {
  return query.answer.is_axis_deeper;
}

/// The axis of its own query, from the right normal by no more than what roundings of the points
/// that it is between turn it: they are that near to each other.
bool axis_turned_by_roundings(const Deviation& d, const RepeatedQuery& query) {
  if (d.got.count == 0 || !of_own_axis(d, query)) return false;
  const double roundings = 4 * d.right.bounds.separation;
  const auto length = static_cast<double>(query.answer.loop.axis.norm());
  const exact::PenetrationCurve curve(*d.right.truth, exact::skin_of(*d.right.truth));
  return std::ranges::any_of(curve.minima(roundings), [&](const Vector2<double>& normal) {
    return (d.got.normal - normal).norm() * length <= roundings;
  });
}

/// The normal was reversed by what is to mend the solver's; the point was not.
bool normal_turned_back(const Deviation& /*d*/, const RepeatedQuery& query) {
  return query.answer.is_turned && !query.answer.is_axis_deeper;
}

/// The solver's GJK found them apart, where the detector's own query had found them to touch.
bool epa_finds_apart(const Deviation& /*d*/, const RepeatedQuery& query) {
  return query.answer.normal_of == NormalOf::solver_apart;
}

/// EPA::Evaluate found no tetrahedron about the origin, gave the hull that it could not expand, or
/// ended within its accuracy.
template <BulletEpaEnd kEnd>
bool epa_ends_at(const Deviation& d, const RepeatedQuery& query) {
  return of_solver(d, query) && query.epa.end == kEnd;
}

constexpr CameAbout within_accuracy = epa_ends_at<BulletEpaEnd::accuracy_reached>;

/// EPA::Evaluate ended at a face beside which the origin is: getedgedist's distance along n is not
/// on the face.
bool epa_beside_face(const Deviation& d, const RepeatedQuery& query) {
  return within_accuracy(d, query) && query.epa.is_beside_face;
}

/// Whether the face is inside of the difference, and nothing is farther along its normal than it is
/// by more than EPA_ACCURACY, so that they are no deeper along it than that beyond the least depth.
bool is_chord_within_accuracy(const Deviation& d, const RepeatedQuery& query) {
  constexpr double accuracy = 1e-4;
  const double bound = d.right.bounds.separation;
  const double least = ledger_of::least_depth(d);
  const double deep = exact::Along(*d.right.truth, d.got.normal).depth();
  return static_cast<double>(query.epa.depth) <= least + bound && deep <= least + accuracy + bound;
}

/// EPA::Evaluate ended within EPA_ACCURACY of a curved corner: its face is not tangent there, so
/// that its points are off, or its normal, along which they are hardly deeper than at least.
bool epa_at_chord(const Deviation& d, const RepeatedQuery& query) {
  const bool is_of_points = ledger_of::is_of_points(d.kind);
  if (total_radius(d.right.pair()) == 0 || (!is_of_points && d.kind != Kind::normal)) return false;
  return within_accuracy(d, query) && !query.epa.is_beside_face &&
         (is_of_points || is_chord_within_accuracy(d, query));
}

/// EPA::Evaluate ended within EPA_ACCURACY of a corner, at a face that is inside of the difference:
/// its depth is too small, its direction no face's. Of sharp shapes.
bool epa_at_inner_face(const Deviation& d, const RepeatedQuery& query) {
  return total_radius(d.right.pair()) <= 0 && within_accuracy(d, query) &&
         !query.epa.is_beside_face &&
         ledger_of::least_depth(d) - static_cast<double>(query.epa.depth) >
             d.right.bounds.separation;
}

/// The solver's GJK took the origin for inside within GJK_MIN_DISTANCE of the difference.
bool epa_is_near(const Deviation& /*d*/, const RepeatedQuery& query) {
  return query.epa.is_near;
}

/// GJK::Evaluate found them neither within each other nor apart, so that there is no direction.
bool epa_without_axis(const Deviation& d, const RepeatedQuery& query) {
  return d.got.count == 0 && query.answer.is_solver_asked &&
         query.answer.normal_of == NormalOf::nobody && query.answer.normal.isZero(0);
}

/// The answer with the normal and the depth of the face that EPA ended at.
replayed::Contact contact_of_face(const Deviation& d, const RepeatedQuery& query) {
  const Vector2<double> outwards(static_cast<double>(query.epa.normal.x()),
                                 static_cast<double>(query.epa.normal.y()));
  const Vector2<double> turn = d.right.pair().a.pose.rotation.cast<double>();
  const ledger_of::Space& on_b = query.answer.on_b;
  return {rotate<double>(turn, outwards).normalized(),
          {{Vector2<float>(on_b.x(), on_b.y()).cast<double>(),
            static_cast<double>(query.epa.depth) * outwards.norm()}}};
}

/// The normal is the direction between two places that are rounded, and not EPA's own: with that,
/// its depth and the same place the answer would be right.
bool epa_normal_between_places(const Deviation& d, const RepeatedQuery& query) {
  return within_accuracy(d, query) &&
         replayed::is_right_answer(d, ledger_of::declaration_of_epa(), contact_of_face(d, query));
}

template <CameAbout kCameAbout>
constexpr auto by_epa = repeated<BulletAsked::epa, kCameAbout>;

constexpr LedgerRow kEpaRows[kBulletEpaRows] = {
    {"direction-of-roundings",
     explained_of<BulletAsked::epa, ledger_of::direction_of_short_translation>},
    {"least-distance", explained_of<BulletAsked::epa, ledger_of::below_gjk_distance, epa_is_near>},
    {"touching-axis", by_epa<axis_of_touching_cores>},
    {"near-corner", by_epa<stopped_at_near_corner>},
    {"relative-error", by_epa<stopped_by_relative_error>},
    {"flat-simplex", by_epa<stopped_at_flat_simplex>},
    {"turned-back", by_epa<normal_turned_back>},
    {"gjk-apart", by_epa<epa_finds_apart>},
    {"fall-back", by_epa<epa_ends_at<BulletEpaEnd::fall_back>>},
    {"invalid-hull", by_epa<epa_ends_at<BulletEpaEnd::invalid_hull>>},
    {"beside-face", by_epa<epa_beside_face>},
    {"chord", by_epa<epa_at_chord>},
    {"axis-of-roundings", by_epa<axis_turned_by_roundings>},
    {"inner-face", by_epa<epa_at_inner_face>},
    {"rounded-point", by_epa<stopped_at_rounded_point>},
    {"between-places", by_epa<epa_normal_between_places>},
    {"without-axis", by_epa<epa_without_axis>},
};

template <BulletAsked kAsked>
bool least_of_directions(const Deviation& d) {
  return ledger_of::is_of_least_direction(d, kAsked);
}

template <BulletAsked kAsked>
bool least_of_directions_of_equal_vertices(const Deviation& d) {
  return ledger_of::is_of_least_direction_of_equal_vertices(d, kAsked);
}

/// Prisms, or flat hulls, with btMinkowskiPenetrationDepthSolver.
template <BulletAsked kAsked>
constexpr LedgerRow kRowsByDirections[] = {
    {kAsked == BulletAsked::flat ? "flattened-directions" : "fixed-directions",
     explained_of<kAsked, least_of_directions<kAsked>>},
    {"direction-of-roundings", explained_of<kAsked, ledger_of::direction_of_short_translation>},
    {"gap-as-depth", explained_of<kAsked, ledger_of::gap_as_depth, of_solver>},
    {"equal-vertices", explained_of<kAsked, least_of_directions_of_equal_vertices<kAsked>>},
    {"touching-axis", repeated<kAsked, axis_of_touching_cores>},
    {"near-corner", repeated<kAsked, stopped_at_near_corner>},
    {"relative-error", repeated<kAsked, stopped_by_relative_error>},
    {"flat-simplex", repeated<kAsked, stopped_at_flat_simplex>},
    {"displaced-point", repeated<kAsked, point_of_displaced_query>},
    {"axis-of-roundings", repeated<kAsked, axis_turned_by_roundings>},
    {"displaced-distance", repeated<kAsked, of_solver>},
    {"axis-taken-back", repeated<kAsked, axis_taken_back>},
    {"rounded-point", repeated<kAsked, stopped_at_rounded_point>},
};

}  // namespace

std::span<const LedgerRow, kBulletEpaRows> bullet_epa_rows() {
  return kEpaRows;
}

std::vector<LedgerRows> bullet_query_ledger() {
  return {{"bullet-epa", kEpaRows},
          {"bullet-minkowski", kRowsByDirections<BulletAsked::directions>},
          {"bullet-convex2d", kRowsByDirections<BulletAsked::flat>},
          bullet_flat_ledger()};
}

}  // namespace manifuzz
