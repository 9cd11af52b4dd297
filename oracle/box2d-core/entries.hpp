#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d-core/deviations.hpp"
#include "oracle/box2d/deviations.hpp"

namespace manifuzz::ledger_of {

// @box2d/core 0.11.0: what it has of Box2D's is looked for as there. Budgets (budgets.json) are
// twice what 300,000 cases against clip64 showed, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfBox2dCore{
    LedgerEntry{.id = "box2d-core-lost-features",
                .collider = "box2d-core",
                .description = "where B's face clips, the feature of A twice: B's is lost where "
                               "both are to be exchanged",
                .source = "@box2d/core 0.11.0, collision/b2_collide_polygon.js, b2CollidePolygons: "
                          "cf.indexA = cf.indexB; cf.indexB = cf.indexA",
                .explains = features_lost_by_two_assignments},
    LedgerEntry{.id = "box2d-core-normal-of-short-face",
                .collider = "box2d-core",
                .description = "a normal as short as its face and hardly any depth: a face below "
                               "1e-5 is not normalised",
                .source = "@box2d/core 0.11.0, common/b2_math.js, b2Vec2.Normalize: length < "
                          "b2_epsilon; common/b2_common.js: b2_epsilon = 1e-5",
                .explains = normal_of_short_face},
    LedgerEntry{.id = "box2d-core-no-contact-under-bias",
                .collider = "box2d-core",
                .description =
                    "no contact for overlapping polygons: A's face is preferred though B's is "
                    "less deep, and the incident edge lies outside its side planes",
                .source = "@box2d/core 0.11.0, collision/b2_collide_polygon.js, b2CollidePolygons: "
                          "k_tol = 0.1 * b2_linearSlop, then `if (np < 2)`",
                .explains = no_contact_under_bias},
    LedgerEntry{.id = "box2d-core-no-contact-on-tied-features",
                .collider = "box2d-core",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in double, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source = "@box2d/core 0.11.0, collision/b2_collide_polygon.js, "
                          "b2FindMaxSeparation and b2FindIncidentEdge: first of equals",
                .explains = no_contact_on_tied_features},
    LedgerEntry{
        .id = "box2d-core-edge-slab-not-widened",
        .collider = "box2d-core",
        .description = "no contact, or too little depth, of a capsule and a polygon near corners: "
                       "what lies within the radii beyond the reference face's ends is cut off",
        .source = "@box2d/core 0.11.0, collision/b2_collide_edge.js, b2CollideEdgeAndPolygon: "
                  "ref.sideOffset1, without the radius that b2CollidePolygons adds",
        .explains = edge_slab_not_widened},
    LedgerEntry{
        .id = "box2d-core-edge-hysteresis",
        .collider = "box2d-core",
        .description = "a capsule's own face is kept though the polygon's is less deep, by 2 % of "
                       "its depth and 0.001",
        .source = "@box2d/core 0.11.0, collision/b2_collide_edge.js, b2CollideEdgeAndPolygon: "
                  "k_relativeTol = 0.98, k_absoluteTol = 0.001",
        .explains = edge_face_kept_by_hysteresis,
        .is_no_bug = true},
    LedgerEntry{.id = "box2d-core-axis-within-epsilon",
                .collider = "box2d-core",
                .description = "a normal along the world's x axis: a circle's centre is within "
                               "1e-5 of another's or of an edge's end",
                .source = "@box2d/core 0.11.0, collision/b2_collision.js, "
                          "b2WorldManifold.Initialize: DistanceSquared(pointA, pointB) > "
                          "b2_epsilon_sq; common/b2_common.js: b2_epsilon = 1e-5",
                .explains = axis_within_box2d_core_epsilon},
    LedgerEntry{.id = "box2d-core-face-within-epsilon",
                .collider = "box2d-core",
                .description = "a face's normal beyond its corner: a circle's centre is within "
                               "1e-5 of a polygon",
                .source = "@box2d/core 0.11.0, collision/b2_collide_circle.js, "
                          "b2CollidePolygonAndCircle: separation < b2_epsilon",
                .explains = face_within_box2d_core_epsilon},
};

}  // namespace manifuzz::ledger_of
