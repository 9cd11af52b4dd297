#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/chipmunk/deviations.hpp"
#include "oracle/pymunk/deviations.hpp"

namespace manifuzz::ledger_of {

// Munk2D, as pymunk 7.3.0 has it: what it has of Chipmunk's is looked for as there. Budgets
// (budgets.json) are twice what 300,000 cases against clip64 showed, or another million, rounded
// up.
/// The entries, the first that explains before others.
inline constexpr std::array kOfMunk{
    LedgerEntry{
        .id = "pymunk-normal-of-world-vertices",
        .collider = "pymunk",
        .description = "a normal off by the roundoff of world coordinates over the face's length",
        .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ClosestPointsNew: `n = "
                  "cpvnormalize(cpvrperp(delta))`, delta of world points",
        .explains = normal_of_rounded_vertices},
    LedgerEntry{.id = "pymunk-corner-on-corner",
                .collider = "pymunk",
                .description = "an arbitrary normal or no contact: a corner of A lies on a "
                               "corner of B",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, GJKRecurse: the direction to "
                          "the nearest point is (0, 0), so no nearer one is found",
                .explains = corner_on_corner},
    LedgerEntry{.id = "pymunk-collinear-apart",
                .collider = "pymunk",
                .description = "contact for polygons well apart: the origin lies on the line of a "
                               "chord of their difference",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ClosestPointsNew: `if(d <= "
                          "0.0f` comes before the distance to the nearer vertex",
                .explains = collinear_and_apart},
    LedgerEntry{.id = "pymunk-wrong-support-edge",
                .collider = "pymunk",
                .description = "too few points, wrong ones or none: the neighbour of the right "
                               "face is clipped, their directions being nearer than a dot can tell",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, SupportEdgeForPoly: "
                          "`cpvdot(n, planes[i1].n) > cpvdot(n, planes[i2].n)`",
                .explains = neighbours_nearly_parallel},
    LedgerEntry{.id = "pymunk-swapped-distance",
                .collider = "pymunk",
                .description = "no depth at all: shapes given in another order than circle, "
                               "segment, polygon, so that distances have the wrong sign",
                .source = "Munk2D of pymunk 7.3.0, src/cpShape.c, cpShapesCollide: distance = "
                          "cpvdot(cpvsub(p2, p1), set.normal), of points not swapped",
                .explains = sign_of_swapped_distance},
    LedgerEntry{.id = "pymunk-direction-of-roundings",
                .collider = "pymunk",
                .description = "a circle's centre on a segment: the normal is the direction of "
                               "roundings between both",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, CircleToSegment: n = "
                          "cpvmult(delta, 1.0f/dist)",
                .explains = direction_to_place_on_segment},
    LedgerEntry{.id = "pymunk-round-corner-on-corner",
                .collider = "pymunk",
                .description =
                    "a normal across any chord, or no contact: a corner of one core lies on the "
                    "other's",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, GJKRecurse: the direction to "
                          "the nearest point is (0, 0), so no nearer one is found",
                .explains = normal_across_corner_on_corner},
    LedgerEntry{.id = "pymunk-round-collinear",
                .collider = "pymunk",
                .description = "a perpendicular normal for capsules end to end, or contact well "
                               "apart: the origin lies on the line of a chord",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ClosestPointsNew: `if(d <= "
                          "0.0f` comes before the distance to the nearer vertex",
                .explains = normal_across_collinear},
    LedgerEntry{.id = "pymunk-depth-by-crossing",
                .collider = "pymunk",
                .description = "too little depth, or none, of an edge end on: its end is found by "
                               "a division by its run along the tangent",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ContactPoints: e1_denom = "
                          "1.0f/(d_e1_b - d_e1_a + CPFLOAT_MIN)",
                .explains = depth_by_crossing},
    LedgerEntry{.id = "pymunk-zero-normal",
                .collider = "pymunk",
                .description = "a normal without length: boxes around both shapes have one middle",
                .source = "Munk2D of pymunk 7.3.0, src/cpCollision.c, ClosestT: `d2 ? ... : 0.0f`, "
                          "of one support point twice",
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
