#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d3/deviations.hpp"
#include "oracle/phaser-box2d/deviations.hpp"

namespace manifuzz::ledger_of {

// Budgets (budgets.json) are twice what 10,000,000 cases against clip64 showed, of round shapes
// 200,000 against clip, of rounded places, faces within slop and nearest places 3,000,000, rounded
// up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfPhaser{
    LedgerEntry{.id = "phaser-box2d-capsule-slips",
                .collider = "phaser-box2d",
                .description =
                    "capsules: two slips of typing: A's ends are projected by u1X where u2X is "
                    "meant, and the greater of two distances is the separation where the "
                    "lesser is meant",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollideCapsules: fp1 = "
                          "(p1.x - p2.x) * u1X + (p1.y - p2.y) * u2Y, s1n = Math.max(-ss1, -ss2)",
                .explains = slips_in_phaser_capsules},
    LedgerEntry{.id = "phaser-box2d-direction-of-rounded-places",
                .collider = "phaser-box2d",
                .description = "capsules nearly in touch: the normal is the direction between the "
                               "nearest points as doubles have them, not an edge's normal",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollideCapsules: normalX = "
                          "closest2.x - closest1.x, over its length",
                .explains = direction_of_rounded_places},
    LedgerEntry{.id = "phaser-box2d-capsule-slop",
                .collider = "phaser-box2d",
                .description = "capsules: an edge's normal within 0.005 of the nearest, clipped "
                               "along it, or one point where edges overlap but not end beside end",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollideCapsules: "
                          "sp <= distance + b2_linearSlop, outsideA, outsideB",
                .explains = slop_in_phaser_capsules},
    LedgerEntry{.id = "phaser-box2d-no-normal-within-epsilon",
                .collider = "phaser-box2d",
                .description = "a normal of no length: a circle's centre is within 1e-10 of the "
                               "other core",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollideCircles: "
                          "distance >= eps; src/include/math_functions_h.js, "
                          "b2GetLengthAndNormalize",
                .explains = no_normal_within_phaser_epsilon},
    LedgerEntry{.id = "phaser-box2d-face-within-epsilon",
                .collider = "phaser-box2d",
                .description = "a face's normal beyond its corner: a circle's centre is within "
                               "1e-10 of a polygon",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollidePolygonAndCircle: "
                          "u1 < 0.0 && separation > eps",
                .explains = face_within_phaser_epsilon},
    LedgerEntry{.id = "phaser-box2d-face-within-slop",
                .collider = "phaser-box2d",
                .description = "a face's normal, and depths along it, where round shapes' cores "
                               "are nearest at corners: no face is farther than 0.0005",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollidePolygons: separationA > "
                          "0.1 * b2_linearSlop || separationB > 0.1 * b2_linearSlop",
                .explains = face_within_phaser_slop,
                .is_no_bug = true},
    LedgerEntry{.id = "phaser-box2d-nearest-by-roundings",
                .collider = "phaser-box2d",
                .description = "edges all but parallel: one point between corners, or a face's "
                               "normal, as the nearest points in double have it",
                .source =
                    "phaser-box2d 1.1.0, src/distance_c.js, b2SegmentDistance: denom = dd1 * "
                    "dd2 - d12 * d12; src/manifold_c.js, b2CollidePolygons: fraction1 === 0.0",
                .explains = nearest_by_phaser_roundings},
    LedgerEntry{.id = "phaser-box2d-normal-over-rounded-distance",
                .collider = "phaser-box2d",
                .description = "a normal between corners that is not unit: their difference over "
                               "the rounded distance of the same points on their edges",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollidePolygons: normalX *= "
                          "invDistance, of result.distanceSquared",
                .explains = normal_over_rounded_distance},
    LedgerEntry{.id = "phaser-box2d-one-point-between-corners",
                .collider = "phaser-box2d",
                .description = "one point where edges overlap: cores are nearest at corners",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollidePolygons and "
                          "b2CollideCapsules: a single point between the nearest vertices",
                .explains = one_point_between_corners,
                .is_no_bug = true},
    LedgerEntry{.id = "phaser-box2d-direction-of-roundings",
                .collider = "phaser-box2d",
                .description = "a circle's centre all but on a capsule's core: the normal is the "
                               "direction of roundings between both",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollideCapsuleAndCircle: "
                          "b2GetLengthAndNormalize(b2Sub(pB, pA))",
                .explains = direction_to_place_on_segment},
    LedgerEntry{.id = "phaser-box2d-edge-extended-to-slab",
                .collider = "phaser-box2d",
                .description =
                    "a point off the polygon, or contact across a gap: an incident edge that "
                    "misses the reference face's slab is prolonged to it",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2ClipPolygons: b2Lerp(v22, v21, "
                          "(lower1 - lower2) / (upper2 - lower2)) with a fraction outside [0, 1]",
                .explains = edge_extended_to_slab},
    LedgerEntry{
        .id = "phaser-box2d-no-contact-on-tied-features",
        .collider = "phaser-box2d",
        .description = "no contact for overlapping polygons: faces or edges tie in double, the "
                       "wrong one is kept, and its slab misses the deepest vertex",
        .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollidePolygons: `dot < minDot`, first "
                  "of equals",
        .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "phaser-box2d-tiny-edge-unclipped",
                .collider = "phaser-box2d",
                .description = "a point beyond the side plane: an incident edge shorter than 1e-10 "
                               "along the reference face is not clipped",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2ClipPolygons: "
                          "`upper2 - lower2 > eps`; src/include/math_functions_h.js: eps = 1.0e-10",
                .explains = incident_edge_unclipped},
};

}  // namespace manifuzz::ledger_of
