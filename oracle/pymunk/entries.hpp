#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/chipmunk/deviations.hpp"
#include "oracle/pymunk/deviations.hpp"

namespace manifuzz::ledger_of {

// Munk2D, as pymunk 7.3.0 has it: what it has of Chipmunk's is looked for as there. Budgets are
// twice what 300,000 cases against clip64 showed, or another million, rounded up.
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
                                                          {"regular", 420},
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
    LedgerEntry{.id = "pymunk-direction-between-corners",
                .collider = "pymunk",
                .description = "a normal of any direction: a corner of one core lies on one of the "
                               "other's, and it is the direction of roundings between both",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ClosestPointsNew: cpvmult(p, "
                          "1.0f/(d2 + CPFLOAT_MIN))",
                .explains = direction_between_corners},
    LedgerEntry{.id = "pymunk-segment-normal-not-unit",
                .collider = "pymunk",
                .description = "a circle's centre on a segment: the normal is as much longer than "
                               "unit as the rotation it was given",
                .source = "Munk2D of pymunk 7.3.0, src/cpShape.c, cpSegmentShapeCacheData: "
                          "cpTransformVect(transform, seg->n)",
                .explains = segment_normal_not_unit},
};

}  // namespace manifuzz::ledger_of
