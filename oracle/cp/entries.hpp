#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/chipmunk/deviations.hpp"
#include "oracle/cp/deviations.hpp"

namespace manifuzz::ledger_of {

// cp 2.4.0, Chipmunk in Go: what it has of Chipmunk's is looked for as there. Budgets are twice
// what 300,000 cases against clip64 showed, rounded up.
inline constexpr Budget kOfCpNormalOfWorldVertices[] = {
    {"boxes", 1000},  {"deep", 600},          {"far_from_origin", 590000},
    {"generic", 600}, {"near_parallel", 200}, {"off_unit", 200},
    {"regular", 400}, {"scaled", 1600},       {"tied_faces", 400},
    {"ulp", 35000},   {"sliver", 360}};
inline constexpr Budget kOfCpCornerOnCorner[] = {
    {"corner_corner", 3000}, {"deep", 2000},   {"grid", 270000},     {"off_unit", 1800},
    {"scaled", 2600},        {"sliver", 4800}, {"tied_faces", 2600}, {"touching", 18000},
    {"ulp", 9200},           {"tie_bias", 400}};
inline constexpr Budget kOfCpCollinearApart[] = {{"grid", 6000}, {"ulp", 200}};
inline constexpr Budget kOfCpWrongSupportEdge[] = {
    {"near_collinear", 3800}, {"tied_faces", 2200}, {"ulp", 200}};
inline constexpr Budget kOfCpSwappedDistance[] = {
    {"capsules", 280000},    {"circles", 150000},      {"cores_touch", 380000},
    {"in_line", 200000},     {"large_radii", 180000},  {"mixed_shapes", 300000},
    {"side_planes", 230000}, {"tilted_edges", 200000}, {"voronoi_lines", 320000}};
inline constexpr Budget kOfCpPolygonRadiusSign[] = {{"circles", 340000},
                                                    {"cores_touch", 67000},
                                                    {"large_radii", 71000},
                                                    {"mixed_shapes", 91000},
                                                    {"voronoi_lines", 190000}};
inline constexpr Budget kOfCpDirectionOfRoundings[] = {{"cores_touch", 110000}};
inline constexpr Budget kOfCpRoundCornerOnCorner[] = {
    {"capsules", 200}, {"cores_touch", 16000}, {"mixed_shapes", 200}};
inline constexpr Budget kOfCpRoundCollinear[] = {{"in_line", 200000}};
inline constexpr Budget kOfCpDepthByCrossing[] = {
    {"capsules", 200},     {"cores_touch", 4000}, {"in_line", 41000},     {"large_radii", 9400},
    {"mixed_shapes", 400}, {"side_planes", 200},  {"voronoi_lines", 5600}};
inline constexpr Budget kOfCpShortNormal[] = {{"capsules", 140000},
                                              {"circles", 240000},
                                              {"cores_touch", 360000},
                                              {"corner_corner", 200000},
                                              {"corner_face", 250000},
                                              {"deep", 47000},
                                              {"far_from_origin", 320000},
                                              {"generic", 52000},
                                              {"grid", 400},
                                              {"in_line", 99000},
                                              {"large_radii", 660000},
                                              {"micro_edge", 410000},
                                              {"mixed_shapes", 200000},
                                              {"near_collinear", 460000},
                                              {"near_parallel", 87000},
                                              {"off_unit", 200000},
                                              {"regular", 9400},
                                              {"round_corners", 400000},
                                              {"scaled", 570000},
                                              {"side_planes", 150000},
                                              {"sliver", 170000},
                                              {"tie_bias", 310000},
                                              {"tied_faces", 200000},
                                              {"tilted_edges", 36000},
                                              {"touching", 160000},
                                              {"ulp", 190000},
                                              {"voronoi_lines", 260000}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfCp{
    LedgerEntry{.id = "cp-short-normal",
                .collider = "cp",
                .description =
                    "a normal shorter than unit by 1e-15 over the length that it was made of, "
                    "or no contact, such normals of two faces being compared",
                .source = "cp v2.4.0, vector.go, Normalize: `v.Mult(1.0 / (v.Length() + 1e-15))`; "
                          "collision.go, ClosestPoints and SupportEdgeForPoly",
                .budgets = kOfCpShortNormal,
                .explains = normal_short_by_cp},
    LedgerEntry{
        .id = "cp-normal-of-world-vertices",
        .collider = "cp",
        .description = "a normal off by the roundoff of world coordinates over the face's length",
        .source = "cp v2.4.0, collision.go, ClosestPoints: `n := delta.ReversePerp().Normalize()`, "
                  "delta of world points",
        .budgets = kOfCpNormalOfWorldVertices,
        .explains = normal_of_rounded_vertices},
    LedgerEntry{.id = "cp-corner-on-corner",
                .collider = "cp",
                .description = "an arbitrary normal or no contact: a corner of A lies on a "
                               "corner of B",
                .source = "cp v2.4.0, collision.go, GJKRecurse: the direction to the nearest point "
                          "is (0, 0), so no nearer one is found",
                .budgets = kOfCpCornerOnCorner,
                .explains = corner_on_corner},
    LedgerEntry{.id = "cp-collinear-apart",
                .collider = "cp",
                .description = "contact for polygons well apart: the origin lies on the line of a "
                               "chord of their difference",
                .source = "cp v2.4.0, collision.go, ClosestPoints: `if d <= 0` comes before the "
                          "distance to the nearer vertex",
                .budgets = kOfCpCollinearApart,
                .explains = collinear_and_apart},
    LedgerEntry{.id = "cp-wrong-support-edge",
                .collider = "cp",
                .description = "too few points, wrong ones or none: the neighbour of the right "
                               "face is clipped, their directions being nearer than a dot can tell",
                .source = "cp v2.4.0, collision.go, SupportEdgeForPoly: `n.Dot(planes[i1].n) > "
                          "n.Dot(planes[i2].n)`",
                .budgets = kOfCpWrongSupportEdge,
                .explains = neighbours_nearly_parallel},
    LedgerEntry{.id = "cp-swapped-distance",
                .collider = "cp",
                .description = "no depth at all: shapes given in another order than circle, "
                               "segment, polygon, so that distances have the wrong sign",
                .source = "cp v2.4.0, shape.go, ShapesCollide: `p2.Sub(p1).Dot(set.Normal)`, of "
                          "points not swapped",
                .budgets = kOfCpSwappedDistance,
                .explains = sign_of_swapped_distance},
    LedgerEntry{
        .id = "cp-polygon-radius-sign",
        .collider = "cp",
        .description = "a circle against a rounded polygon: too little depth by twice the "
                       "polygon's radius, and its point as much too far",
        .source = "cp v2.4.0, collision.go, CircleToPoly: `points.b.Add(info.n.Mult(poly.r))`",
        .budgets = kOfCpPolygonRadiusSign,
        .explains = sign_of_polygon_radius},
    LedgerEntry{
        .id = "cp-direction-of-roundings",
        .collider = "cp",
        .description = "a circle's centre on a segment: the normal is the direction of "
                       "roundings between both",
        .source = "cp v2.4.0, collision.go, CircleToSegment: `info.n = delta.Mult(1 / dist)`",
        .budgets = kOfCpDirectionOfRoundings,
        .explains = direction_to_place_on_segment},
    LedgerEntry{.id = "cp-round-corner-on-corner",
                .collider = "cp",
                .description =
                    "a normal across any chord, or no contact: a corner of one core lies on the "
                    "other's",
                .source = "cp v2.4.0, collision.go, GJKRecurse: the direction to the nearest point "
                          "is (0, 0), so no nearer one is found",
                .budgets = kOfCpRoundCornerOnCorner,
                .explains = normal_across_corner_on_corner},
    LedgerEntry{.id = "cp-round-collinear",
                .collider = "cp",
                .description = "a perpendicular normal for capsules end to end, or contact well "
                               "apart: the origin lies on the line of a chord",
                .source = "cp v2.4.0, collision.go, ClosestPoints: `if d <= 0` comes before the "
                          "distance to the nearer vertex",
                .budgets = kOfCpRoundCollinear,
                .explains = normal_across_collinear},
    LedgerEntry{
        .id = "cp-depth-by-crossing",
        .collider = "cp",
        .description = "too little depth, or none, of an edge end on: its end is found by "
                       "a division by its run along the tangent",
        .source = "cp v2.4.0, collision.go, ContactPoints: `e1Denom := 1 / (dE1B - dE1A + 1e-15)`",
        .budgets = kOfCpDepthByCrossing,
        .explains = depth_by_crossing},
    LedgerEntry{.id = "cp-segment-normal-not-unit",
                .collider = "cp",
                .description = "a circle's centre on a segment: the normal is as much longer than "
                               "unit as the rotation it was given",
                .source = "cp v2.4.0, segment.go, CacheData: `transform.Vect(seg.n)`",
                .explains = segment_normal_not_unit},
};

}  // namespace manifuzz::ledger_of
