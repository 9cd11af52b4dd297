#pragma once

#include <array>

#include "judging/ledger/round_deviations.hpp"
#include "judging/ledger/separating_axes/axes_deviations.hpp"

namespace manifuzz::ledger_of {

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
