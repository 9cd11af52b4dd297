#pragma once

#include <array>

#include "judging/ledger/round_deviations.hpp"

namespace manifuzz::ledger_of {

// Munk2D, as pymunk 7.3.0 has it, and cp 2.4.0, Chipmunk in Go: what they have of Chipmunk's is
// looked for as there. Budgets are twice what 300,000 cases against clip64 showed, rounded up.
inline constexpr Budget kOfMunkNormalOfWorldVertices[] = {{"boxes", 600},
                                                          {"corner_corner", 2600},
                                                          {"corner_face", 3000},
                                                          {"deep", 600},
                                                          {"far_from_origin", 870000},
                                                          {"generic", 1000},
                                                          {"micro_edge", 11000},
                                                          {"near_collinear", 13000},
                                                          {"near_parallel", 400},
                                                          {"off_unit", 2800},
                                                          {"scaled", 1800},
                                                          {"sliver", 7000},
                                                          {"tie_bias", 3200},
                                                          {"tied_faces", 200},
                                                          {"ulp", 52000}};
inline constexpr Budget kOfMunkCornerOnCorner[] = {
    {"corner_corner", 800}, {"deep", 1400},   {"grid", 260000},  {"off_unit", 3200},
    {"scaled", 2800},       {"sliver", 2800}, {"tie_bias", 600}, {"tied_faces", 1800},
    {"touching", 18000},    {"ulp", 8000}};
inline constexpr Budget kOfMunkCollinearApart[] = {
    {"grid", 6800}, {"tied_faces", 200}, {"ulp", 200}};
inline constexpr Budget kOfMunkWrongSupportEdge[] = {
    {"near_collinear", 15000}, {"tied_faces", 3200}, {"ulp", 600}};
inline constexpr Budget kOfMunkSwappedDistance[] = {
    {"capsules", 310000},    {"circles", 410000},      {"cores_touch", 490000},
    {"in_line", 210000},     {"large_radii", 380000},  {"mixed_shapes", 390000},
    {"side_planes", 280000}, {"tilted_edges", 200000}, {"voronoi_lines", 510000}};
inline constexpr Budget kOfMunkDirectionOfRoundings[] = {{"cores_touch", 120000}};
inline constexpr Budget kOfMunkRoundCornerOnCorner[] = {{"capsules", 200}, {"cores_touch", 41000}};
inline constexpr Budget kOfMunkRoundCollinear[] = {
    {"cores_touch", 14000}, {"in_line", 240000}, {"mixed_shapes", 200}};
inline constexpr Budget kOfMunkDepthByCrossing[] = {
    {"capsules", 600},      {"cores_touch", 11000}, {"in_line", 74000},      {"large_radii", 21000},
    {"mixed_shapes", 1000}, {"side_planes", 200},   {"voronoi_lines", 10000}};
inline constexpr Budget kOfMunkZeroNormal[] = {{"boxes", 200}, {"cores_touch", 13000}};
inline constexpr Budget kOfCpNormalOfWorldVertices[] = {
    {"boxes", 1000},         {"deep", 800},          {"far_from_origin", 590000}, {"generic", 600},
    {"near_collinear", 400}, {"near_parallel", 200}, {"off_unit", 200},           {"regular", 600},
    {"scaled", 1600},        {"ulp", 35000}};
inline constexpr Budget kOfCpCornerOnCorner[] = {
    {"corner_corner", 3000}, {"deep", 2000},      {"grid", 270000},
    {"off_unit", 1800},      {"scaled", 2600},    {"sliver", 4800},
    {"tied_faces", 2600},    {"touching", 18000}, {"ulp", 9200}};
inline constexpr Budget kOfCpCollinearApart[] = {{"grid", 6000}, {"ulp", 200}};
inline constexpr Budget kOfCpWrongSupportEdge[] = {
    {"near_collinear", 9000}, {"tied_faces", 4400}, {"ulp", 1600}};
inline constexpr Budget kOfCpSwappedDistance[] = {
    {"capsules", 270000},    {"circles", 150000},      {"cores_touch", 380000},
    {"in_line", 200000},     {"large_radii", 180000},  {"mixed_shapes", 300000},
    {"side_planes", 230000}, {"tilted_edges", 200000}, {"voronoi_lines", 320000}};
inline constexpr Budget kOfCpPolygonRadiusSign[] = {{"circles", 340000},
                                                    {"cores_touch", 66000},
                                                    {"large_radii", 71000},
                                                    {"mixed_shapes", 89000},
                                                    {"voronoi_lines", 190000}};
inline constexpr Budget kOfCpDirectionOfRoundings[] = {{"cores_touch", 110000}};
inline constexpr Budget kOfCpRoundCornerOnCorner[] = {
    {"capsules", 200}, {"cores_touch", 40000}, {"mixed_shapes", 200}};
inline constexpr Budget kOfCpRoundCollinear[] = {{"in_line", 200000}};
inline constexpr Budget kOfCpDepthByCrossing[] = {
    {"capsules", 6600},      {"cores_touch", 31000}, {"in_line", 72000},
    {"large_radii", 270000}, {"mixed_shapes", 5200}, {"round_corners", 7000},
    {"side_planes", 3400},   {"tilted_edges", 400},  {"voronoi_lines", 11000}};
inline constexpr Budget kOfCpShortNormal[] = {{"capsules", 130000},
                                              {"circles", 240000},
                                              {"cores_touch", 170000},
                                              {"corner_corner", 200000},
                                              {"corner_face", 250000},
                                              {"deep", 47000},
                                              {"far_from_origin", 320000},
                                              {"generic", 52000},
                                              {"in_line", 68000},
                                              {"large_radii", 86000},
                                              {"micro_edge", 410000},
                                              {"mixed_shapes", 200000},
                                              {"near_collinear", 450000},
                                              {"near_parallel", 87000},
                                              {"off_unit", 200000},
                                              {"regular", 9200},
                                              {"round_corners", 390000},
                                              {"scaled", 570000},
                                              {"side_planes", 150000},
                                              {"sliver", 170000},
                                              {"tie_bias", 310000},
                                              {"tied_faces", 200000},
                                              {"tilted_edges", 37000},
                                              {"touching", 160000},
                                              {"ulp", 190000},
                                              {"voronoi_lines", 250000}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfMunk{
    LedgerEntry{
        .id = "pymunk-normal-of-world-vertices",
        .collider = "pymunk",
        .description = "a normal off by the roundoff of world coordinates over the face's length",
        .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ClosestPointsNew: `n = "
                  "cpvnormalize(cpvrperp(delta))`, delta of world points",
        .budgets = kOfMunkNormalOfWorldVertices,
        .explains = normal_of_rounded_vertices},
    LedgerEntry{.id = "pymunk-corner-on-corner",
                .collider = "pymunk",
                .description = "an arbitrary normal or no contact: a corner of A lies on a "
                               "corner of B",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, GJKRecurse: the direction to "
                          "the nearest point is (0, 0), so no nearer one is found",
                .budgets = kOfMunkCornerOnCorner,
                .explains = corner_on_corner},
    LedgerEntry{.id = "pymunk-collinear-apart",
                .collider = "pymunk",
                .description = "contact for polygons well apart: the origin lies on the line of a "
                               "chord of their difference",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ClosestPointsNew: `if(d <= "
                          "0.0f` comes before the distance to the nearer vertex",
                .budgets = kOfMunkCollinearApart,
                .explains = collinear_and_apart},
    LedgerEntry{.id = "pymunk-wrong-support-edge",
                .collider = "pymunk",
                .description = "too few points, wrong ones or none: the neighbour of the right "
                               "face is clipped, their directions being nearer than a dot can tell",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, SupportEdgeForPoly: "
                          "`cpvdot(n, planes[i1].n) > cpvdot(n, planes[i2].n)`",
                .budgets = kOfMunkWrongSupportEdge,
                .explains = neighbours_nearly_parallel},
    LedgerEntry{.id = "pymunk-swapped-distance",
                .collider = "pymunk",
                .description = "no depth at all: shapes given in another order than circle, "
                               "segment, polygon, so that distances have the wrong sign",
                .source = "Munk2D of pymunk 7.3.0, src/cpShape.c, cpShapesCollide: distance = "
                          "cpvdot(cpvsub(p2, p1), set.normal), of points not swapped",
                .budgets = kOfMunkSwappedDistance,
                .explains = sign_of_swapped_distance},
    LedgerEntry{.id = "pymunk-direction-of-roundings",
                .collider = "pymunk",
                .description = "a circle's centre on a segment: the normal is the direction of "
                               "roundings between both",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, CircleToSegment: n = "
                          "cpvmult(delta, 1.0f/dist)",
                .budgets = kOfMunkDirectionOfRoundings,
                .explains = direction_to_place_on_segment},
    LedgerEntry{.id = "pymunk-round-corner-on-corner",
                .collider = "pymunk",
                .description =
                    "a normal across any chord, or no contact: a corner of one core lies on the "
                    "other's",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, GJKRecurse: the direction to "
                          "the nearest point is (0, 0), so no nearer one is found",
                .budgets = kOfMunkRoundCornerOnCorner,
                .explains = normal_across_corner_on_corner},
    LedgerEntry{.id = "pymunk-round-collinear",
                .collider = "pymunk",
                .description = "a perpendicular normal for capsules end to end, or contact well "
                               "apart: the origin lies on the line of a chord",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ClosestPointsNew: `if(d <= "
                          "0.0f` comes before the distance to the nearer vertex",
                .budgets = kOfMunkRoundCollinear,
                .explains = normal_across_collinear},
    LedgerEntry{.id = "pymunk-depth-by-crossing",
                .collider = "pymunk",
                .description = "too little depth, or none, of an edge end on: its end is found by "
                               "a division by its run along the tangent",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ContactPoints: e1_denom = "
                          "1.0f/(d_e1_b - d_e1_a + CPFLOAT_MIN)",
                .budgets = kOfMunkDepthByCrossing,
                .explains = depth_by_crossing},
    LedgerEntry{.id = "pymunk-zero-normal",
                .collider = "pymunk",
                .description = "a normal without length: boxes around both shapes have one middle",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ClosestT: `d2 ? ... : 0.0f`, "
                          "of one support point twice",
                .budgets = kOfMunkZeroNormal,
                .explains = zero_normal_of_one_middle},
};

/// The entries, the first that explains before others.
inline constexpr std::array kOfCp{
    LedgerEntry{
        .id = "cp-short-normal",
        .collider = "cp",
        .description = "a normal shorter than unit by 1e-15 over the length that it was made of",
        .source = "cp v2.4.0, vector.go, Normalize: `v.Mult(1.0 / (v.Length() + 1e-15))`; "
                  "collision.go, ClosestPoints",
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
};

}  // namespace manifuzz::ledger_of
