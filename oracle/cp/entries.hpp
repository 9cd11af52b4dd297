#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/chipmunk/deviations.hpp"
#include "oracle/cp/deviations.hpp"

namespace manifuzz::ledger_of {

// cp 2.4.0, Chipmunk in Go: what it has of Chipmunk's is looked for as there. Budgets
// (budgets.json) are twice what 300,000 cases against clip64 showed, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfCp{
    LedgerEntry{.id = "cp-short-normal",
                .collider = "cp",
                .description =
                    "a normal shorter than unit by 1e-15 over the length that it was made of, "
                    "or no contact, such normals of two faces being compared",
                .source = "cp v2.4.0, vector.go, Normalize: `v.Mult(1.0 / (v.Length() + 1e-15))`; "
                          "collision.go, ClosestPoints and SupportEdgeForPoly",
                .explains = normal_short_by_cp},
    LedgerEntry{
        .id = "cp-normal-of-world-vertices",
        .collider = "cp",
        .description = "a normal off by the roundoff of world coordinates over the face's length",
        .source = "cp v2.4.0, collision.go, ClosestPoints: `n := delta.ReversePerp().Normalize()`, "
                  "delta of world points",
        .explains = normal_of_rounded_vertices},
    LedgerEntry{.id = "cp-corner-on-corner",
                .collider = "cp",
                .description = "an arbitrary normal or no contact: a corner of A lies on a "
                               "corner of B",
                .source = "cp v2.4.0, collision.go, GJKRecurse: the direction to the nearest point "
                          "is (0, 0), so no nearer one is found",
                .explains = corner_on_corner},
    LedgerEntry{.id = "cp-collinear-apart",
                .collider = "cp",
                .description = "contact for polygons well apart: the origin lies on the line of a "
                               "chord of their difference",
                .source = "cp v2.4.0, collision.go, ClosestPoints: `if d <= 0` comes before the "
                          "distance to the nearer vertex",
                .explains = collinear_and_apart},
    LedgerEntry{.id = "cp-wrong-support-edge",
                .collider = "cp",
                .description = "too few points, wrong ones or none: the neighbour of the right "
                               "face is clipped, their directions being nearer than a dot can tell",
                .source = "cp v2.4.0, collision.go, SupportEdgeForPoly: `n.Dot(planes[i1].n) > "
                          "n.Dot(planes[i2].n)`",
                .explains = neighbours_nearly_parallel},
    LedgerEntry{.id = "cp-swapped-distance",
                .collider = "cp",
                .description = "no depth at all: shapes given in another order than circle, "
                               "segment, polygon, so that distances have the wrong sign",
                .source = "cp v2.4.0, shape.go, ShapesCollide: `p2.Sub(p1).Dot(set.Normal)`, of "
                          "points not swapped",
                .explains = sign_of_swapped_distance},
    LedgerEntry{
        .id = "cp-polygon-radius-sign",
        .collider = "cp",
        .description = "a circle against a rounded polygon: too little depth by twice the "
                       "polygon's radius, and its point as much too far",
        .source = "cp v2.4.0, collision.go, CircleToPoly: `points.b.Add(info.n.Mult(poly.r))`",
        .explains = sign_of_polygon_radius},
    LedgerEntry{
        .id = "cp-direction-of-roundings",
        .collider = "cp",
        .description = "a circle's centre on a segment: the normal is the direction of "
                       "roundings between both",
        .source = "cp v2.4.0, collision.go, CircleToSegment: `info.n = delta.Mult(1 / dist)`",
        .explains = direction_to_place_on_segment},
    LedgerEntry{.id = "cp-round-corner-on-corner",
                .collider = "cp",
                .description =
                    "a normal across any chord, or no contact: a corner of one core lies on the "
                    "other's",
                .source = "cp v2.4.0, collision.go, GJKRecurse: the direction to the nearest point "
                          "is (0, 0), so no nearer one is found",
                .explains = normal_across_corner_on_corner},
    LedgerEntry{.id = "cp-round-collinear",
                .collider = "cp",
                .description = "a perpendicular normal for capsules end to end, or contact well "
                               "apart: the origin lies on the line of a chord",
                .source = "cp v2.4.0, collision.go, ClosestPoints: `if d <= 0` comes before the "
                          "distance to the nearer vertex",
                .explains = normal_across_collinear},
    LedgerEntry{
        .id = "cp-depth-by-crossing",
        .collider = "cp",
        .description = "too little depth, or none, of an edge end on: its end is found by "
                       "a division by its run along the tangent",
        .source = "cp v2.4.0, collision.go, ContactPoints: `e1Denom := 1 / (dE1B - dE1A + 1e-15)`",
        .explains = depth_by_crossing},
    LedgerEntry{.id = "cp-segment-normal-not-unit",
                .collider = "cp",
                .description = "a circle's centre on a segment: the normal is as much longer than "
                               "unit as the rotation it was given",
                .source = "cp v2.4.0, segment.go, CacheData: `transform.Vect(seg.n)`",
                .explains = segment_normal_not_unit},
};

}  // namespace manifuzz::ledger_of
