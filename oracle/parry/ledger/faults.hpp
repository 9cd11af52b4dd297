#pragma once

#include <string_view>

#include "oracle/parry/ledger/deviations.hpp"

namespace manifuzz::ledger_of {

/// What is at fault, in words, and where: one of several colliders that have parry inside. All the
/// lines named are the same in parry2d 0.30.2 and 0.31.1.
struct ParryFault {
  std::string_view description;
  std::string_view source;
};

inline constexpr ParryFault kFaceByCosine{
    "points too few, too shallow or too near: faces are clipped whose normals are the nearest to "
    "the direction as cosines tell, not those that touch",
    "parry2d 0.30.2 and 0.31.1, src/shape/convex_polygon.rs, local_support_feature: `dot > "
    "max_dot`"};
inline constexpr ParryFault kNormalsBefore{
    "one point, or points too near: another face is clipped, since those that are left have the "
    "normals that they had before corners were dropped",
    "parry2d 0.30.2 and 0.31.1, src/shape/convex_polygon.rs, from_convex_polyline: "
    "normals[i2 - nremoved] = normals[i2]"};
inline constexpr ParryFault kSquaredLength{
    "a normal of no length, and depth 0: the square of a face's length is beyond a float",
    "parry2d 0.30.2 and 0.31.1, src/utils/ccw_face_normal.rs: try_normalize; "
    "src/query/epa/epa2.rs, Face::new_with_proj"};
inline constexpr ParryFault kEdgeAlongNormal{
    "no contact, or too shallow: an edge along the normal is clipped, and its first end or its "
    "middle is taken though its other end is the nearest; or an edge nearly along it, as much "
    "farther from its end as roundings are times its length over its run",
    "parry2d 0.30.2 and 0.31.1, src/query/clip/clip_segment_segment.rs: utils::inv(range2[1] - "
    "range2[0]), 0 of 0 or large"};
inline constexpr ParryFault kNotANumber{
    "places and depths that are not numbers: an edge all but along the normal is clipped, and 0 is "
    "multiplied by its run's reciprocal, which is infinite",
    "parry2d 0.30.2 and 0.31.1, src/query/clip/clip_segment_segment.rs: utils::inv(range2[1] - "
    "range2[0]), of less than the reciprocal of the greatest number"};
inline constexpr ParryFault kCornerCones{
    "a normal outside the cone of a corner that touches a corner: it is turned into A's cone, then "
    "into B's, and not back",
    "parry2d 0.30.2 and 0.31.1, src/query/epa/epa2.rs, EPA::closest_points: simplex.dimension() == "
    "0"};
inline constexpr ParryFault kLostByEpa{
    "no contact, or a circle's at its own centre: GJK says that the origin is inside, and EPA "
    "finds "
    "it outside of a face",
    "parry2d 0.30.2 and 0.31.1, src/query/epa/epa2.rs, EPA::closest_points: FaceId::new(...)?"};
inline constexpr ParryFault kDirectionOfRoundings{
    "cores apart by little: the normal is the direction between places that are rounded",
    "parry2d 0.30.2 and 0.31.1, src/query/gjk/gjk.rs, closest_points: "
    "neg_proj_coords.normalize_and_length(); "
    "contact_manifolds_capsule_capsule.rs: (local_p2_1 - local_p1).try_normalize()"};
inline constexpr ParryFault kStepBack{
    "a normal off by 2e-4 (in double 1e-8): the nearest places before a step that does not lessen "
    "their rounded distance, though it turns the direction between them",
    "parry2d 0.30.2 and 0.31.1, src/query/gjk/gjk.rs, closest_points: max_bound >= old_max_bound, "
    "result(simplex, true), old_dir"};
inline constexpr ParryFault kGjkStop{
    "a normal short of the nearest by up to 1.1e-3 (in double 4.7e-8) of the cores' distance",
    "parry2d 0.30.2 and 0.31.1, src/query/gjk/gjk.rs, closest_points: max_bound - min_bound <= "
    "_eps_rel * max_bound"};
inline constexpr ParryFault kTouchingWithin{
    "an arbitrary normal, or no contact: an overlap or a gap below 1.1e-3 (in double 4.7e-8) of "
    "the reach is taken for a touch",
    "parry2d 0.30.2 and 0.31.1, src/query/gjk/gjk.rs, closest_points: best_min_bound >= -_eps_rel "
    "* support_scale"};
inline constexpr ParryFault kOriginWithin{
    "an arbitrary normal, or contact across such a gap: the origin is within 10 epsilon of the "
    "simplex, and a new face of EPA's seems nearer than the one it came from, or it is a corner, "
    "or of a chord the far side is taken, the gap for an overlap",
    "parry2d 0.30.2 and 0.31.1, src/query/epa/epa2.rs, EPA::closest_points: `dist < curr_dist`; "
    "FaceId::new(0, dist1, dist_tol), of a chord without a triangle's minus; gjk.rs: dist > "
    "_eps_tol"};
inline constexpr ParryFault kEqualCorners{
    "an arbitrary answer: corners nearer than 1.1e-3 (in double 4.7e-8), an absolute length, are "
    "taken for one",
    "parry2d 0.30.2 and 0.31.1, src/query/gjk/voronoi_simplex2.rs, add_point: length_squared() < "
    "gjk::eps_tol()"};
inline constexpr ParryFault kRoundedFoot{
    "normal and depth of a chord, or of a gap that is taken for an overlap: the place on it that "
    "is nearest to the origin is rounded, and the direction from it leads back to the chord",
    "parry2d 0.30.2 and 0.31.1, src/query/gjk/gjk.rs, closest_points: "
    "!simplex.add_point(cso_point); src/query/point/point_segment.rs: self.a + ab * u"};
inline constexpr ParryFault kSecondPoint{
    "of two capsules one point, or a second that is not the clip's other end",
    "parry2d 0.30.2 and 0.31.1, src/query/contact_manifolds/contact_manifolds_capsule_capsule.rs: "
    "dir1.dot(dir2)."
    "abs() >= COS_FRAC_PI_8; (clip_a.0 - local_p1).length_squared()"};
inline constexpr ParryFault kCrossingCapsules{
    "capsules whose cores cross or touch: the depth is the sum of the radii, the normal y or a "
    "direction of roundings",
    "parry2d 0.30.2 and 0.31.1, src/query/contact_manifolds/contact_manifolds_capsule_capsule.rs: "
    "(local_p2_1 - "
    "local_p1).try_normalize().unwrap_or(Vector::Y)"};
inline constexpr ParryFault kNearlyParallel{
    "capsules that are nearly parallel, or shorter than the root of epsilon: other places than the "
    "nearest",
    "parry2d 0.30.2 and 0.31.1, src/query/closest_points/closest_points_segment_segment.rs: denom "
    "> _eps, (b * f - c "
    "* e) / denom; a <= _eps"};
inline constexpr ParryFault kCornerOfChord{
    "a circle's centre on a rounded polygon's edge: it is projected on an end of a chord",
    "parry2d 0.30.2 and 0.31.1, src/query/epa/epa2.rs, EPA::closest_points: new_with_proj(..., "
    "[1.0, 0.0], ...)"};
inline constexpr ParryFault kCentreOnSurface{
    "a circle's centre on the other's surface or core: the normal is a direction of roundings, or "
    "that from the other's origin",
    "parry2d 0.30.2 and 0.31.1, src/query/contact_manifolds/contact_manifolds_convex_ball.rs: `if "
    "dist == 0.0`; "
    "src/query/point/point_capsule.rs: dist >= default_epsilon()"};
inline constexpr ParryFault kCentreOnSurfaceOfContact{
    kCentreOnSurface.description,
    "parry2d 0.31.1, src/query/contact/contact_ball_convex_polyhedron.rs, "
    "contact_convex_polyhedron_ball: len >= DEFAULT_EPSILON; src/query/point/point_capsule.rs: "
    "dist >= default_epsilon()"};
inline constexpr ParryFault kCircleByGjk{
    "a circle beside a polygon: depth and normal short by GJK's relative tolerance, 1.1e-3 (in "
    "double 4.7e-8) of the distance and the root of that",
    "parry2d 0.30.2 and 0.31.1, src/query/point/point_support_map.rs: gjk::project_origin; gjk.rs: "
    "max_bound - "
    "min_bound <= _eps_rel * max_bound"};
inline constexpr ParryFault kEpaChord{
    "normal, depth and places are those of a chord that EPA ends on, inside of the surface: of "
    "round shapes, and of faces that are nearly in line; no contact where the chord, along a face, "
    "goes through the origin",
    "parry2d 0.30.2 and 0.31.1, src/query/epa/epa2.rs, EPA::closest_points: "
    "best_face.closest_points(), of the face "
    "with the least support; niter > 100"};

/// An entry of a collider on such a fault.
constexpr LedgerEntry of_parry(std::string_view id, std::string_view collider,
                               const ParryFault& fault, bool (*explains)(const Deviation&)) {
  return {id, collider, fault.description, fault.source, explains};
}

/// An entry of a collider whose answers are lost by such a fault.
constexpr LedgerEntry of_parry_lost(std::string_view id, std::string_view collider,
                                    const ParryFault& fault,
                                    bool (*explains_lost)(const LostAnswer&)) {
  LedgerEntry entry = of_parry(id, collider, fault, nullptr);
  entry.explains_lost = explains_lost;
  return entry;
}

}  // namespace manifuzz::ledger_of
