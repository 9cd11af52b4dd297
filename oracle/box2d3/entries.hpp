#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d3/deviations.hpp"

namespace manifuzz::ledger_of {

// Box2D 3.2.0, in float. Budgets (budgets.json) are twice what 1,000,000 cases against clip64
// showed, of what floats decide otherwise 300,000, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfBox2d3{
    LedgerEntry{.id = "box2d3-no-contact-on-tied-features",
                .collider = "box2d3",
                .description = "no contact for overlapping polygons: faces or edges tie in float, "
                               "the wrong one is kept, and its slab misses the deepest vertex",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2FindMaxSeparation: `si "
                          "> maxSeparation`, b2CollidePolygons: `dot < minDot`, first of equals",
                .explains = no_contact_on_tied_features},
    LedgerEntry{
        .id = "box2d3-corner-beyond-slab",
        .collider = "box2d3",
        .description =
            "no contact of corners with radii: no face is farther than 0.0005, and edges "
            "are clipped though they are beside each other",
        .source =
            "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2CollidePolygons: separationA > 0.1f * "
            "linearSlop; b2ClipPolygons: `upper2 < lower1 || upper1 < lower2`, without the radii",
        .explains = corner_beyond_slab},
    LedgerEntry{.id = "box2d3-capsule-slop",
                .collider = "box2d3",
                .description =
                    "of two capsules, an edge's normal within 0.005 of the distance, A's within "
                    "0.0005 of B's, A's left side where cores touch, and one point where a core's "
                    "ends are both beyond the other's",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2CollideCapsules: sp <= "
                          "distance + B2_LINEAR_SLOP; separationA + 0.1f * B2_LINEAR_SLOP >= "
                          "separationB; normal = b2LeftPerp( u1 ); outsideA, outsideB",
                .explains = capsules_of_box2d3},
    LedgerEntry{.id = "box2d3-one-point-between-corners",
                .collider = "box2d3",
                .description = "one point of two: cores are nearest at a vertex of each",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2CollidePolygons and "
                          "b2CollideCapsules: a single point between the nearest vertices",
                .explains = one_point_between_corners,
                .is_no_bug = true},
    LedgerEntry{.id = "box2d3-face-within-slop",
                .collider = "box2d3",
                .description = "a face's normal though corners beside it are nearer, by up to "
                               "0.0005: a round pair with two edges",
                .source =
                    "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2CollidePolygons: separation + "
                    "0.1f * linearSlop < minSeparation; separationA > 0.1f * linearSlop",
                .explains = face_within_box2d3_slop,
                .is_no_bug = true},
    LedgerEntry{.id = "box2d3-no-normal-within-epsilon",
                .collider = "box2d3",
                .description = "a normal of no length: a circle's centre is within 1.2e-7 of the "
                               "other core",
                .source = "Box2D 3.2.0, commit 56edae79, include/box2d/math_functions.h, "
                          "b2GetLengthAndNormalize: *length < FLT_EPSILON",
                .explains = no_normal_within_box2d3_epsilon},
    LedgerEntry{.id = "box2d3-direction-of-rounded-place",
                .collider = "box2d3",
                .description = "a circle's centre all but on a capsule's core or a polygon's "
                               "corner: the normal is the direction of roundings between both",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, "
                          "b2CollideCapsuleAndCircle: pA = b2MulAdd( p1, s, e ); "
                          "b2CollidePolygonAndCircle: b2Normalize( b2Sub( center, v1 ) )",
                .explains = direction_of_rounded_place},
    LedgerEntry{
        .id = "box2d3-capsule-roundings",
        .collider = "box2d3",
        .description = "of two capsules, what floats decide otherwise than doubles: which "
                       "side, end or place is nearer, and by which direction",
        .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2CollideCapsules: denom = dd1 * "
                  "dd2 - d12 * d12; s1p > s1n; outsideA, outsideB; normal = b2Normalize( normal )",
        .explains = roundings_in_box2d3_capsules},
    LedgerEntry{.id = "box2d3-normal-over-rounded-distance",
                .collider = "box2d3",
                .description = "a normal between corners that is not unit: their difference over "
                               "the rounded distance of the same points on their edges",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2CollidePolygons: "
                          "normal.x *= invDistance, of result.distanceSquared",
                .explains = normal_over_box2d3_distance},
    LedgerEntry{.id = "box2d3-no-distance",
                .collider = "box2d3",
                .description = "a normal that is not a number: of corners that floats have at one "
                               "place, though a face is farther than 0.0005",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2CollidePolygons: "
                          "invDistance = 1.0f / distance",
                .explains_lost = normal_over_no_distance},
    LedgerEntry{.id = "box2d3-squares-beyond-float",
                .collider = "box2d3",
                .description = "a point that is not a number: of two segments or capsules, the "
                               "product of whose cores' squared lengths is beyond a float",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2CollideCapsules: denom "
                          "= dd1 * dd2 - d12 * d12",
                .explains_lost = squares_beyond_box2d3_range},
    LedgerEntry{.id = "box2d3-edge-below-epsilon",
                .collider = "box2d3",
                .description = "an end beyond a side plane: an incident edge that is shorter than "
                               "1.2e-7 along the face is not clipped",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2ClipPolygons: upper2 - "
                          "lower2 > FLT_EPSILON",
                .explains = edge_below_box2d3_epsilon},
    LedgerEntry{.id = "box2d3-neither-clipped-nor-corner",
                .collider = "box2d3",
                .description = "no contact of edges that are apart: floats have them miss each "
                               "other along the face, yet nearest inside of one",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, b2ClipPolygons: upper2 < "
                          "lower1 || upper1 < lower2; b2CollidePolygons: result.fraction1 == 0.0f",
                .explains = neither_clipped_nor_corner},
    LedgerEntry{.id = "box2d3-circle-tied-faces",
                .collider = "box2d3",
                .description = "a circle's normal from the end of a face where another face is "
                               "nearest: both tie in float, and the first is kept",
                .source = "Box2D 3.2.0, commit 56edae79, src/manifold.c, "
                          "b2CollidePolygonAndCircle: `if ( s > separation )`, in floats",
                .explains = corner_of_tied_face},
};

}  // namespace manifuzz::ledger_of
