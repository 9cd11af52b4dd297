#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d/deviations.hpp"
#include "oracle/jbox2d/deviations.hpp"

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
    {"capsules", 62000}, {"mixed_shapes", 11000}, {"voronoi_lines", 32000}};
inline constexpr Budget kOfJbox2dCoincidentPoints[] = {{"cores_touch", 43000}};
inline constexpr Budget kOfJbox2dDirectionOfRoundings[] = {{"cores_touch", 1600}};
inline constexpr Budget kOfJbox2dEdgeRadius[] = {
    {"capsules", 97000}, {"mixed_shapes", 26000}, {"voronoi_lines", 36000}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfJbox2d{
    LedgerEntry{
        .id = "jbox2d-tiny-reference-face",
        .collider = "jbox2d",
        .description =
            "a wrong normal or no contact: the reference face is shorter than b2_epsilon, "
            "so its direction is not normalised, or than world coordinates resolve",
        .source =
            "jbox2d 2.2.1.1, org/jbox2d/common/Vec2.java, normalize: `length < Settings.EPSILON` "
            "leaves the tangent of Collision.collidePolygons as short as it is",
        .budgets = kOfJbox2dTinyReferenceFace,
        .explains = tiny_reference_face},
    LedgerEntry{
        .id = "jbox2d-no-contact-under-bias",
        .collider = "jbox2d",
        .description = "no contact for overlapping polygons: A's face is preferred though B's is "
                       "less deep, and the incident edge lies outside its side planes",
        .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, collidePolygons: "
                  "`results2.separation > k_relativeTol * results1.separation + k_absoluteTol`",
        .budgets = kOfJbox2dNoContactUnderBias,
        .explains = no_contact_under_bias},
    LedgerEntry{.id = "jbox2d-no-contact-on-tied-features",
                .collider = "jbox2d",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in float, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, findMaxSeparation "
                          "and findIncidentEdge: the first of what floats cannot tell apart",
                .budgets = kOfJbox2dNoContactOnTiedFeatures,
                .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "jbox2d-edge-slab-not-widened",
                .collider = "jbox2d",
                .description =
                    "no contact, or too little depth, of a capsule and a polygon near corners: "
                    "what lies within the radii beyond the reference face's ends is cut off",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, "
                          "EPCollider.collide: side offsets without m_radius",
                .budgets = kOfJbox2dEdgeSlabNotWidened,
                .explains = edge_slab_not_widened},
    LedgerEntry{.id = "jbox2d-coincident-points",
                .collider = "jbox2d",
                .description = "a normal along the world's x axis, into the edge: a circle's "
                               "centre lies on the end of an edge",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/WorldManifold.java, initialize, "
                          "CIRCLES: `normal.x = 1`",
                .budgets = kOfJbox2dCoincidentPoints,
                .explains = axis_for_coincident_points},
    LedgerEntry{.id = "jbox2d-direction-of-roundings",
                .collider = "jbox2d",
                .description = "a normal into the core: a circle's centre lies on an edge's end or "
                               "a polygon's corner, but for roundings, and their direction is it",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/WorldManifold.java, initialize: "
                          "the direction between two points, however near",
                .budgets = kOfJbox2dDirectionOfRoundings,
                .explains = direction_of_roundings},
    LedgerEntry{.id = "jbox2d-edge-radius",
                .collider = "jbox2d",
                .description =
                    "no contact of an edge and a polygon that are farther apart than 0.02, the "
                    "radius of every edge of jbox2d's own",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, "
                          "EPCollider.collide: `m_radius = 2.0f * Settings.polygonRadius`",
                .budgets = kOfJbox2dEdgeRadius,
                .explains = edge_radius_of_settings,
                .is_no_bug = true},
};

// What jbox2d 2.2.1.1 has of Box2D 2.2's search for the best face, in float. Budgets are twice what
// 300,000 cases against clip64 showed, rounded up.
inline constexpr Budget kOfJbox2dLocalMaximum[] = {
    {"deep", 170000}, {"micro_edge", 19000}, {"near_collinear", 730}, {"scaled", 190},
    {"sliver", 4000}, {"tied_faces", 1900},  {"ulp", 15000}};

inline constexpr Budget kOfJbox2dSecondPoint[] = {
    {"capsules", 4900}, {"mixed_shapes", 1300}, {"voronoi_lines", 2000}};
inline constexpr Budget kOfJbox2dHysteresis[] = {{"capsules", 1700}, {"mixed_shapes", 440}};
inline constexpr Budget kOfJbox2dCornerDirection[] = {{"cores_touch", 550}};
inline constexpr Budget kOfJbox2dEdgeFront[] = {{"capsules", 600}, {"mixed_shapes", 200}};
inline constexpr Budget kOfJbox2dEdgeCorners[] = {{"capsules", 200}, {"mixed_shapes", 200}};

inline constexpr std::array kOfJbox2dSearch{
    LedgerEntry{.id = "jbox2d-local-maximum",
                .collider = "jbox2d",
                .description = "another face, or no contact: the search from the direction between "
                               "the centroids ends at a local maximum of the separation",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, findMaxSeparation: "
                          "s > bestSeparation, else break",
                .budgets = kOfJbox2dLocalMaximum,
                .explains = local_maximum_in_jbox2d},
    LedgerEntry{
        .id = "jbox2d-second-point-within-radius",
        .collider = "jbox2d",
        .description = "one point of an edge and a polygon, or too little depth: what is farther "
                       "from the reference face's core than 0.02 is left out, whatever the radii",
        .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, EPCollider.collide: "
                  "`separation <= m_radius`, of m_radius = 2.0f * Settings.polygonRadius",
        .budgets = kOfJbox2dSecondPoint,
        .explains = fault_of_jbox2d_edge<FaultOfJbox2dEdge::radius>},
    LedgerEntry{
        .id = "jbox2d-edge-hysteresis",
        .collider = "jbox2d",
        .description = "an edge's own face is kept though the polygon's is less deep, by 2 "
                       "% of its separation and 0.001",
        .source =
            "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, EPCollider.collide: "
            "k_relativeTol = 0.98f, k_absoluteTol = 0.001f, `Use hysteresis for jitter reduction`",
        .budgets = kOfJbox2dHysteresis,
        .explains = fault_of_jbox2d_edge<FaultOfJbox2dEdge::hysteresis>,
        .is_no_bug = true},
    LedgerEntry{
        .id = "jbox2d-huge-reference-face",
        .collider = "jbox2d",
        .description = "no normal and no depth, or no contact: the square of the reference "
                       "face's length is beyond float",
        .source =
            "jbox2d 2.2.1.1, org/jbox2d/common/Vec2.java, normalize: length() of x * x + y * y",
        .explains = huge_reference_face},
    LedgerEntry{.id = "jbox2d-crossing-underflows",
                .collider = "jbox2d",
                .description =
                    "no contact for overlapping polygons: an end of the incident edge all but "
                    "touches a side plane, the product of distances underflows",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, clipSegmentToLine: "
                          "`distance0 * distance1 < 0.0f`",
                .explains = crossing_underflows},
    LedgerEntry{.id = "jbox2d-corner-direction-not-normalised",
                .collider = "jbox2d",
                .description = "a normal of no length: a circle's centre lies on a polygon's "
                               "corner, or within epsilon of it",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, "
                          "collidePolygonAndCircle: manifold.localNormal.normalize(); "
                          "org/jbox2d/common/Vec2.java, normalize: `length < Settings.EPSILON`",
                .budgets = kOfJbox2dCornerDirection,
                .explains = corner_direction_not_normalised},
    LedgerEntry{.id = "jbox2d-edge-front",
                .collider = "jbox2d",
                .description = "a face that is not the least deep: of an edge's two sides the one "
                               "towards the polygon's centroid alone is tried",
                .source =
                    "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, EPCollider.collide: "
                    "`m_front = offset1 >= 0.0f`, offset1 of m_centroidB",
                .budgets = kOfJbox2dEdgeFront,
                .explains = fault_of_jbox2d_edge<FaultOfJbox2dEdge::front>},
    LedgerEntry{.id = "jbox2d-edge-corners",
                .collider = "jbox2d",
                .description = "too little depth of an edge's end and a polygon's corner, or no "
                               "contact: they are clipped along a face's normal",
                .source =
                    "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, EPCollider.collide: "
                    "primaryAxis is the edge's or one of the polygon's faces, none between "
                    "corners",
                .budgets = kOfJbox2dEdgeCorners,
                .explains = fault_of_jbox2d_edge<FaultOfJbox2dEdge::corners>},
};

}  // namespace manifuzz::ledger_of
