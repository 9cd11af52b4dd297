#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d/deviations.hpp"
#include "oracle/jbox2d/deviations.hpp"

namespace manifuzz::ledger_of {

// jbox2d 2.2.1.1, Box2D 2.2 in Java: what it has of Box2D's is looked for as there. Budgets
// (budgets.json) are twice what 300,000 cases against clip64 showed, rounded up.

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
        .explains = tiny_reference_face},
    LedgerEntry{
        .id = "jbox2d-no-contact-under-bias",
        .collider = "jbox2d",
        .description = "no contact for overlapping polygons: A's face is preferred though B's is "
                       "less deep, and the incident edge lies outside its side planes",
        .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, collidePolygons: "
                  "`results2.separation > k_relativeTol * results1.separation + k_absoluteTol`",
        .explains = no_contact_under_bias},
    LedgerEntry{.id = "jbox2d-no-contact-on-tied-features",
                .collider = "jbox2d",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in float, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, findMaxSeparation "
                          "and findIncidentEdge: the first of what floats cannot tell apart",
                .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "jbox2d-edge-slab-not-widened",
                .collider = "jbox2d",
                .description =
                    "no contact, or too little depth, of a capsule and a polygon near corners: "
                    "what lies within the radii beyond the reference face's ends is cut off",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, "
                          "EPCollider.collide: side offsets without m_radius",
                .explains = edge_slab_not_widened},
    LedgerEntry{.id = "jbox2d-coincident-points",
                .collider = "jbox2d",
                .description = "a normal along the world's x axis, into the edge: a circle's "
                               "centre lies on the end of an edge",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/WorldManifold.java, initialize, "
                          "CIRCLES: `normal.x = 1`",
                .explains = axis_for_coincident_points},
    LedgerEntry{.id = "jbox2d-direction-of-roundings",
                .collider = "jbox2d",
                .description = "a normal into the core: a circle's centre lies on an edge's end or "
                               "a polygon's corner, but for roundings, and their direction is it",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/WorldManifold.java, initialize: "
                          "the direction between two points, however near",
                .explains = direction_of_roundings},
    LedgerEntry{.id = "jbox2d-edge-radius",
                .collider = "jbox2d",
                .description =
                    "no contact of an edge and a polygon that are farther apart than 0.02, the "
                    "radius of every edge of jbox2d's own",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, "
                          "EPCollider.collide: `m_radius = 2.0f * Settings.polygonRadius`",
                .explains = edge_radius_of_settings,
                .is_no_bug = true},
};

// What jbox2d 2.2.1.1 has of Box2D 2.2's search for the best face, in float. Budgets (budgets.json)
// are twice what 300,000 cases against clip64 showed, rounded up.

inline constexpr std::array kOfJbox2dSearch{
    LedgerEntry{.id = "jbox2d-local-maximum",
                .collider = "jbox2d",
                .description = "another face, or no contact: the search from the direction between "
                               "the centroids ends at a local maximum of the separation",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, findMaxSeparation: "
                          "s > bestSeparation, else break",
                .explains = local_maximum_in_jbox2d},
    LedgerEntry{
        .id = "jbox2d-second-point-within-radius",
        .collider = "jbox2d",
        .description = "one point of an edge and a polygon, or too little depth: what is farther "
                       "from the reference face's core than 0.02 is left out, whatever the radii",
        .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, EPCollider.collide: "
                  "`separation <= m_radius`, of m_radius = 2.0f * Settings.polygonRadius",
        .explains = fault_of_jbox2d_edge<FaultOfJbox2dEdge::radius>},
    LedgerEntry{
        .id = "jbox2d-edge-hysteresis",
        .collider = "jbox2d",
        .description = "an edge's own face is kept though the polygon's is less deep, by 2 "
                       "% of its separation and 0.001",
        .source =
            "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, EPCollider.collide: "
            "k_relativeTol = 0.98f, k_absoluteTol = 0.001f, `Use hysteresis for jitter reduction`",
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
                .explains = corner_direction_not_normalised},
    LedgerEntry{.id = "jbox2d-edge-front",
                .collider = "jbox2d",
                .description = "a face that is not the least deep: of an edge's two sides the one "
                               "towards the polygon's centroid alone is tried",
                .source =
                    "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, EPCollider.collide: "
                    "`m_front = offset1 >= 0.0f`, offset1 of m_centroidB",
                .explains = fault_of_jbox2d_edge<FaultOfJbox2dEdge::front>},
    LedgerEntry{.id = "jbox2d-edge-corners",
                .collider = "jbox2d",
                .description = "too little depth of an edge's end and a polygon's corner, or no "
                               "contact: they are clipped along a face's normal",
                .source =
                    "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, EPCollider.collide: "
                    "primaryAxis is the edge's or one of the polygon's faces, none between "
                    "corners",
                .explains = fault_of_jbox2d_edge<FaultOfJbox2dEdge::corners>},
    LedgerEntry{.id = "jbox2d-circle-tied-faces",
                .collider = "jbox2d",
                .description = "a circle's normal from the end of a face where another face is "
                               "nearest: both tie in float, and the first is kept",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, "
                          "collidePolygonAndCircle: `if (s > separation)`, in floats",
                .explains = tied_face_of_box2d_circle},
};

}  // namespace manifuzz::ledger_of
