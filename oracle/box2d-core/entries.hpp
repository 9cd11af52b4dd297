#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d-core/deviations.hpp"
#include "oracle/box2d/deviations.hpp"

namespace manifuzz::ledger_of {

// @box2d/core 0.11.0: what it has of Box2D's is looked for as there. Budgets are twice what 300,000
// cases against clip64 showed, rounded up.
inline constexpr Budget kOfBox2dCoreLostFeatures[] = {
    {"boxes", 230000},        {"corner_corner", 250000},   {"corner_face", 530000},
    {"deep", 780000},         {"far_from_origin", 490000}, {"generic", 390000},
    {"grid", 230000},         {"micro_edge", 330000},      {"near_collinear", 120000},
    {"near_parallel", 87000}, {"off_unit", 480000},        {"regular", 350000},
    {"scaled", 350000},       {"sliver", 510000},          {"tie_bias", 200000},
    {"tied_faces", 520000},   {"touching", 380000},        {"ulp", 370000}};
inline constexpr Budget kOfBox2dCoreNormalOfShortFace[] = {
    {"micro_edge", 93000}, {"scaled", 130000}, {"ulp", 13000}};
inline constexpr Budget kOfBox2dCoreNoContactUnderBias[] = {{"corner_corner", 9800},
                                                            {"deep", 200},
                                                            {"far_from_origin", 2000},
                                                            {"micro_edge", 12000},
                                                            {"near_collinear", 200},
                                                            {"off_unit", 3400},
                                                            {"regular", 600},
                                                            {"scaled", 17000},
                                                            {"sliver", 4000},
                                                            {"tie_bias", 63000},
                                                            {"tied_faces", 200},
                                                            {"touching", 1000},
                                                            {"ulp", 7800}};
inline constexpr Budget kOfBox2dCoreNoContactOnTiedFeatures[] = {{"near_collinear", 7200},
                                                                 {"ulp", 200}};
inline constexpr Budget kOfBox2dCoreEdgeSlabNotWidened[] = {
    {"capsules", 54000}, {"mixed_shapes", 16000}, {"voronoi_lines", 45000}};
inline constexpr Budget kOfBox2dCoreEdgeHysteresis[] = {{"capsules", 600}, {"mixed_shapes", 400}};
inline constexpr Budget kOfBox2dCoreAxisWithinEpsilon[] = {{"cores_touch", 170000}};
inline constexpr Budget kOfBox2dCoreFaceWithinEpsilon[] = {{"cores_touch", 34000}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfBox2dCore{
    LedgerEntry{.id = "box2d-core-lost-features",
                .collider = "box2d-core",
                .description = "where B's face clips, the feature of A twice: B's is lost where "
                               "both are to be exchanged",
                .source = "@box2d/core 0.11.0, collision/b2_collide_polygon.js, b2CollidePolygons: "
                          "cf.indexA = cf.indexB; cf.indexB = cf.indexA",
                .budgets = kOfBox2dCoreLostFeatures,
                .explains = features_lost_by_two_assignments},
    LedgerEntry{.id = "box2d-core-normal-of-short-face",
                .collider = "box2d-core",
                .description = "a normal as short as its face and hardly any depth: a face below "
                               "1e-5 is not normalised",
                .source = "@box2d/core 0.11.0, common/b2_math.js, b2Vec2.Normalize: length < "
                          "b2_epsilon; common/b2_common.js: b2_epsilon = 1e-5",
                .budgets = kOfBox2dCoreNormalOfShortFace,
                .explains = normal_of_short_face},
    LedgerEntry{.id = "box2d-core-no-contact-under-bias",
                .collider = "box2d-core",
                .description =
                    "no contact for overlapping polygons: A's face is preferred though B's is "
                    "less deep, and the incident edge lies outside its side planes",
                .source = "@box2d/core 0.11.0, collision/b2_collide_polygon.js, b2CollidePolygons: "
                          "k_tol = 0.1 * b2_linearSlop, then `if (np < 2)`",
                .budgets = kOfBox2dCoreNoContactUnderBias,
                .explains = no_contact_under_bias},
    LedgerEntry{.id = "box2d-core-no-contact-on-tied-features",
                .collider = "box2d-core",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in double, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source = "@box2d/core 0.11.0, collision/b2_collide_polygon.js, "
                          "b2FindMaxSeparation and b2FindIncidentEdge: first of equals",
                .budgets = kOfBox2dCoreNoContactOnTiedFeatures,
                .explains = no_contact_on_tied_features},
    LedgerEntry{
        .id = "box2d-core-edge-slab-not-widened",
        .collider = "box2d-core",
        .description = "no contact, or too little depth, of a capsule and a polygon near corners: "
                       "what lies within the radii beyond the reference face's ends is cut off",
        .source = "@box2d/core 0.11.0, collision/b2_collide_edge.js, b2CollideEdgeAndPolygon: "
                  "ref.sideOffset1, without the radius that b2CollidePolygons adds",
        .budgets = kOfBox2dCoreEdgeSlabNotWidened,
        .explains = edge_slab_not_widened},
    LedgerEntry{
        .id = "box2d-core-edge-hysteresis",
        .collider = "box2d-core",
        .description = "a capsule's own face is kept though the polygon's is less deep, by 2 % of "
                       "its depth and 0.001",
        .source = "@box2d/core 0.11.0, collision/b2_collide_edge.js, b2CollideEdgeAndPolygon: "
                  "k_relativeTol = 0.98, k_absoluteTol = 0.001",
        .budgets = kOfBox2dCoreEdgeHysteresis,
        .explains = edge_face_kept_by_hysteresis,
        .is_no_bug = true},
    LedgerEntry{.id = "box2d-core-axis-within-epsilon",
                .collider = "box2d-core",
                .description = "a normal along the world's x axis: a circle's centre is within "
                               "1e-5 of another's or of an edge's end",
                .source = "@box2d/core 0.11.0, collision/b2_collision.js, "
                          "b2WorldManifold.Initialize: DistanceSquared(pointA, pointB) > "
                          "b2_epsilon_sq; common/b2_common.js: b2_epsilon = 1e-5",
                .budgets = kOfBox2dCoreAxisWithinEpsilon,
                .explains = axis_within_box2d_core_epsilon},
    LedgerEntry{.id = "box2d-core-face-within-epsilon",
                .collider = "box2d-core",
                .description = "a face's normal beyond its corner: a circle's centre is within "
                               "1e-5 of a polygon",
                .source = "@box2d/core 0.11.0, collision/b2_collide_circle.js, "
                          "b2CollidePolygonAndCircle: separation < b2_epsilon",
                .budgets = kOfBox2dCoreFaceWithinEpsilon,
                .explains = face_within_box2d_core_epsilon},
};

}  // namespace manifuzz::ledger_of
