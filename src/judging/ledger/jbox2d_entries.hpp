#pragma once

#include <array>

#include "judging/ledger/round_deviations.hpp"

namespace manifuzz::ledger_of {

// jbox2d 2.2.1.1, Box2D 2.2 in Java: what it has of Box2D's is looked for as there. Budgets are
// twice what 300,000 cases against clip64 showed, rounded up.
inline constexpr Budget kOfJbox2dTinyReferenceFace[] = {
    {"micro_edge", 7400}, {"scaled", 400}, {"ulp", 400}};
inline constexpr Budget kOfJbox2dNoContactUnderBias[] = {
    {"corner_corner", 3000}, {"corner_face", 600}, {"deep", 2600},       {"far_from_origin", 400},
    {"generic", 200},        {"grid", 200},        {"micro_edge", 7000}, {"near_collinear", 800},
    {"off_unit", 200},       {"scaled", 18000},    {"sliver", 3600},     {"tie_bias", 69000},
    {"tied_faces", 200},     {"ulp", 5400}};
inline constexpr Budget kOfJbox2dNoContactOnTiedFeatures[] = {{"corner_corner", 200},
                                                              {"near_collinear", 49000},
                                                              {"sliver", 5400},
                                                              {"tied_faces", 27000},
                                                              {"ulp", 4800}};
inline constexpr Budget kOfJbox2dEdgeSlabNotWidened[] = {
    {"capsules", 25000}, {"mixed_shapes", 11000}, {"voronoi_lines", 32000}};
inline constexpr Budget kOfJbox2dCoincidentPoints[] = {{"cores_touch", 43000}};
inline constexpr Budget kOfJbox2dDirectionOfRoundings[] = {{"cores_touch", 1600}};
inline constexpr Budget kOfJbox2dEdgeRadius[] = {
    {"capsules", 97000}, {"mixed_shapes", 26000}, {"voronoi_lines", 36000}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfJbox2d{
    LedgerEntry{.id = "jbox2d-tiny-reference-face",
                .collider = "jbox2d",
                .description =
                    "a wrong normal or no contact: the reference face is shorter than b2_epsilon, "
                    "so its direction is not normalised, or than world coordinates resolve",
                .source = "jbox2d 2.2.1.1, Vec2.normalize: `length < Settings.EPSILON` leaves the "
                          "tangent of Collision.collidePolygons as short as it is",
                .budgets = kOfJbox2dTinyReferenceFace,
                .explains = tiny_reference_face},
    LedgerEntry{.id = "jbox2d-no-contact-under-bias",
                .collider = "jbox2d",
                .description =
                    "no contact for overlapping polygons: the bias keeps A's shallower face, whose "
                    "side planes the incident edge misses",
                .source = "jbox2d 2.2.1.1, Collision.collidePolygons: `results2.separation > "
                          "k_relativeTol * results1.separation + k_absoluteTol`",
                .budgets = kOfJbox2dNoContactUnderBias,
                .explains = no_contact_under_bias},
    LedgerEntry{.id = "jbox2d-no-contact-on-tied-features",
                .collider = "jbox2d",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in float, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source = "jbox2d 2.2.1.1, Collision.findMaxSeparation and findIncidentEdge: the "
                          "first of what floats cannot tell apart",
                .budgets = kOfJbox2dNoContactOnTiedFeatures,
                .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "jbox2d-edge-slab-not-widened",
                .collider = "jbox2d",
                .description =
                    "no contact, or too little depth, of a capsule and a polygon near corners: "
                    "what lies within the radii beyond the reference face's ends is cut off",
                .source = "jbox2d 2.2.1.1, EPCollider.collide: side offsets without m_radius",
                .budgets = kOfJbox2dEdgeSlabNotWidened,
                .explains = edge_slab_not_widened},
    LedgerEntry{.id = "jbox2d-coincident-points",
                .collider = "jbox2d",
                .description = "a normal along the world's x axis, into the edge: a circle's "
                               "centre lies on the end of an edge",
                .source = "jbox2d 2.2.1.1, WorldManifold.initialize, CIRCLES: `normal.x = 1`",
                .budgets = kOfJbox2dCoincidentPoints,
                .explains = axis_for_coincident_points},
    LedgerEntry{.id = "jbox2d-direction-of-roundings",
                .collider = "jbox2d",
                .description = "a normal into the core: a circle's centre lies on an edge's end or "
                               "a polygon's corner, but for roundings, and their direction is it",
                .source = "jbox2d 2.2.1.1, WorldManifold.initialize: the direction between two "
                          "points, however near",
                .budgets = kOfJbox2dDirectionOfRoundings,
                .explains = direction_of_roundings},
    LedgerEntry{
        .id = "jbox2d-edge-radius",
        .collider = "jbox2d",
        .description = "no contact of an edge and a polygon that are farther apart than 0.02, "
                       "whatever their radii",
        .source = "jbox2d 2.2.1.1, EPCollider.collide: `m_radius = 2.0f * Settings.polygonRadius`",
        .budgets = kOfJbox2dEdgeRadius,
        .explains = edge_radius_of_settings},
};

}  // namespace manifuzz::ledger_of
