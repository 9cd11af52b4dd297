#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/chipmunk/deviations.hpp"

namespace manifuzz::ledger_of {

// Chipmunk 7.0.3. Budgets (budgets.json) are twice what 10,000,000 cases against clip64 showed, of
// round shapes 9,000,000 against clip, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfChipmunk{
    LedgerEntry{
        .id = "chipmunk-normal-of-world-vertices",
        .collider = "chipmunk",
        .description = "a normal off by the roundoff of world coordinates over the face's length",
        .source = "Chipmunk 7.0.3, src/cpCollision.c, ClosestPointsNew: "
                  "`n = cpvnormalize(cpvrperp(delta))`, delta of world points",
        .explains = normal_of_rounded_vertices},
    LedgerEntry{.id = "chipmunk-corner-on-corner",
                .collider = "chipmunk",
                .description = "an arbitrary normal or no contact: a corner of A lies on a "
                               "corner of B",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, GJKRecurse: the direction to the "
                          "nearest point is (0, 0), so no nearer one is found",
                .explains = corner_on_corner},
    LedgerEntry{.id = "chipmunk-collinear-apart",
                .collider = "chipmunk",
                .description = "contact for polygons well apart: the origin lies on the line of a "
                               "chord of their difference",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, ClosestPointsNew: `if(d <= 0.0f` "
                          "comes before the distance to the nearer vertex",
                .explains = collinear_and_apart},
    LedgerEntry{.id = "chipmunk-wrong-support-edge",
                .collider = "chipmunk",
                .description = "too few points, wrong ones or none: the neighbour of the right "
                               "face is clipped, their directions being nearer than a dot can tell",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, SupportEdgeForPoly: "
                          "`cpvdot(n, planes[i1].n) > cpvdot(n, planes[i2].n)`",
                .explains = neighbours_nearly_parallel},
    LedgerEntry{.id = "chipmunk-swapped-distance",
                .collider = "chipmunk",
                .description = "no depth at all: shapes given in another order than circle, "
                               "segment, polygon, so that distances have the wrong sign",
                .source = "Chipmunk 7.0.3, src/cpShape.c, cpShapesCollide: distance = "
                          "cpvdot(cpvsub(p2, p1), set.normal), of points not swapped",
                .explains = sign_of_swapped_distance},
    LedgerEntry{.id = "chipmunk-polygon-radius-sign",
                .collider = "chipmunk",
                .description = "a circle against a rounded polygon: too little depth by twice the "
                               "polygon's radius, and its point as much too far",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, CircleToPoly: "
                          "cpvadd(points.b, cpvmult(n, poly->r))",
                .explains = sign_of_polygon_radius},
    LedgerEntry{.id = "chipmunk-direction-of-roundings",
                .collider = "chipmunk",
                .description = "a circle's centre on a segment: the normal is the direction of "
                               "roundings between both",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, CircleToSegment: "
                          "n = cpvmult(delta, 1.0f/dist)",
                .explains = direction_to_place_on_segment},
    LedgerEntry{.id = "chipmunk-round-corner-on-corner",
                .collider = "chipmunk",
                .description =
                    "a normal across any chord, or no contact: a corner of one core lies on the "
                    "other's",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, GJKRecurse: the direction to the "
                          "nearest point is (0, 0), so no nearer one is found",
                .explains = normal_across_corner_on_corner},
    LedgerEntry{.id = "chipmunk-round-collinear",
                .collider = "chipmunk",
                .description = "a perpendicular normal for capsules end to end, or contact well "
                               "apart: the origin lies on the line of a chord",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, ClosestPointsNew: `if(d <= 0.0f` "
                          "comes before the distance to the nearer vertex",
                .explains = normal_across_collinear},
    LedgerEntry{.id = "chipmunk-depth-by-crossing",
                .collider = "chipmunk",
                .description = "too little depth, or none, of an edge end on: its end is found by "
                               "a division by its run along the tangent",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, ContactPoints: "
                          "e1_denom = 1.0f/(d_e1_b - d_e1_a + CPFLOAT_MIN)",
                .explains = depth_by_crossing},
    LedgerEntry{.id = "chipmunk-direction-between-corners",
                .collider = "chipmunk",
                .description = "a normal of any direction: a corner of one core lies on one of the "
                               "other's, and it is the direction of roundings between both",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, ClosestPointsNew: cpvmult(p, "
                          "1.0f/(d2 + CPFLOAT_MIN))",
                .explains = direction_between_corners},
    LedgerEntry{.id = "chipmunk-segment-normal-not-unit",
                .collider = "chipmunk",
                .description = "a circle's centre on a segment: the normal is as much longer than "
                               "unit as the rotation it was given",
                .source = "Chipmunk 7.0.3, src/cpShape.c, cpSegmentShapeCacheData: "
                          "cpTransformVect(transform, seg->n)",
                .explains = segment_normal_not_unit},
};

}  // namespace manifuzz::ledger_of
