#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on Bullet look for that repeat its query in its own floats: the answer
// is what the repeated query gives, and that came about by the named rule.

/// What oracle/bullet/epa.cpp declares.
Declaration declaration_of_epa();

/// How Bullet was asked: prisms with its EPA or with its fixed directions, or flat hulls with
/// these.
enum class BulletAsked { epa, directions, flat };

/// What another predicate looks for, where the answer is the repeated one and the normal the depth
/// solver's.
bool is_of_solver(const Deviation& deviation, BulletAsked asked);
template <BulletAsked asked, bool (*explains)(const Deviation&)>
bool by_solver(const Deviation& deviation) {
  return explains(deviation) && is_of_solver(deviation, asked);
}
/// The same, whosever the normal is.
bool is_of_query(const Deviation& deviation, BulletAsked asked);
template <BulletAsked asked, bool (*explains)(const Deviation&)>
bool by_query(const Deviation& deviation) {
  return explains(deviation) && is_of_query(deviation, asked);
}

/// btGjkPairDetector keeps its own query's axis though that ended below 0.001, the root of
/// REL_ERROR2, or takes it back from the depth solver: its direction is the roundings'.
template <BulletAsked>
bool axis_of_touching_cores(const Deviation& deviation);
/// The loop whose distance decides ended at a corner that is another than the simplex holds, within
/// VORONOI_DEFAULT_EQUAL_VERTEX_THRESHOLD.
template <BulletAsked>
bool stopped_at_near_corner(const Deviation& deviation);
/// It ended at a corner that its simplex holds, though that is nearer than the closest point said
/// to be the simplex's: roundings of squares and of products of squares decide which it is.
template <BulletAsked>
bool stopped_at_rounded_point(const Deviation& deviation);
/// It ended though corners were left, since the squared distance fell by less than REL_ERROR2 of
/// it, or by no more than a rounding, or would have fallen by less with the corner that roundings
/// of products hid; a normal is off by no more than the root of that.
template <BulletAsked>
bool stopped_by_relative_error(const Deviation& deviation);
/// It ended at four corners that pointOutsideOfPlane takes for coplanar, or at a closest point of
/// negative weights.
template <BulletAsked>
bool stopped_at_flat_simplex(const Deviation& deviation);
/// The solver's normal and depth with a point of the displaced query, whose own normal is another.
template <BulletAsked>
bool point_of_displaced_query(const Deviation& deviation);
/// The solver's direction, and for a depth what the distance of the displaced query leaves of the
/// displacement, all rounded as it rounds them.
template <BulletAsked>
bool distance_of_displaced_query(const Deviation& deviation);
/// The axis of its own query, wherever that ended, took the place of the solver's normal, since
/// they are less deep along it: d2 > d0.
template <BulletAsked>
bool axis_taken_back(const Deviation& deviation);
/// The axis of its own query, from the right normal by no more than what roundings of the points
/// that it is between turn it: they are that near to each other.
template <BulletAsked>
bool axis_turned_by_roundings(const Deviation& deviation);
/// The normal was reversed by what is to mend the solver's; the point was not.
template <BulletAsked>
bool normal_turned_back(const Deviation& deviation);
/// The solver's GJK found them apart, where the detector's own query had found them to touch.
bool epa_finds_apart(const Deviation& deviation);
/// EPA::Evaluate found no tetrahedron about the origin: its guess and a depth of 0.
bool epa_falls_back(const Deviation& deviation);

/// The solver's GJK took the origin for inside within GJK_MIN_DISTANCE of the difference.
bool epa_below_least_distance(const Deviation& deviation);
/// GJK::Evaluate found them neither within each other nor apart, so that there is no direction.
bool epa_without_axis(const Deviation& deviation);
/// The normal is the direction between two places that are rounded, and not EPA's own: with that,
/// its depth and the same place the answer would be right.
bool epa_normal_between_places(const Deviation& deviation);

/// Flat hulls: the answer where the detector takes cores for intersecting, or does not, of which
/// it had a corner that is none of theirs: -1 indexes their corners.
bool corner_before_first(const Deviation& deviation);

/// EPA::Evaluate ended at a hull that it could not expand, and gives the face it had.
bool epa_at_invalid_hull(const Deviation& deviation);
/// EPA::Evaluate ended at a face beside which the origin is: getedgedist's distance along n is not
/// on the face.
bool epa_beside_face(const Deviation& deviation);
/// EPA::Evaluate ended within EPA_ACCURACY of a corner, at a face that is inside of the difference:
/// its depth is too small, its direction no face's. Of sharp shapes.
bool epa_at_inner_face(const Deviation& deviation);
/// EPA::Evaluate ended within EPA_ACCURACY of a curved corner: its face is not tangent there, so
/// that its points are off, or its normal, along which they are hardly deeper than at least.
bool epa_at_chord(const Deviation& deviation);

}  // namespace manifuzz
