#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d/deviations.hpp"
#include "oracle/planck/deviations.hpp"

namespace manifuzz::ledger_of {

// Budgets are twice what 10,000,000 cases against clip64 showed, of round shapes 1,050,000, rounded
// up.
inline constexpr Budget kOfPlanckNoContactUnderBias[] = {{"generic", 70},
                                                         {"boxes", 20},
                                                         {"regular", 130},
                                                         {"sliver", 5700},
                                                         {"near_parallel", 20},
                                                         {"tied_faces", 30},
                                                         {"micro_edge", 12000},
                                                         {"near_collinear", 280},
                                                         {"corner_corner", 12000},
                                                         {"corner_face", 20},
                                                         {"touching", 1400},
                                                         {"deep", 40},
                                                         {"tie_bias", 63000},
                                                         {"far_from_origin", 2700},
                                                         {"scaled", 20000},
                                                         {"off_unit", 2600},
                                                         {"ulp", 7600}};
inline constexpr Budget kOfPlanckNoContactOnTiedFeatures[] = {{"near_collinear", 9100},
                                                              {"ulp", 500}};
inline constexpr Budget kOfPlanckEdgeHysteresis[] = {
    {"capsules", 670}, {"mixed_shapes", 320}, {"voronoi_lines", 54}};
inline constexpr Budget kOfPlanckEdgeSlabNotWidened[] = {
    {"capsules", 59000}, {"mixed_shapes", 20000}, {"voronoi_lines", 41000}};
inline constexpr Budget kOfPlanckAxisWithinEpsilon[] = {{"cores_touch", 40000}};
inline constexpr Budget kOfPlanckFaceWithinEpsilon[] = {{"cores_touch", 7600}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfPlanck{
    LedgerEntry{.id = "planck-edge-slab-not-widened",
                .collider = "planck",
                .description =
                    "no contact, or too little depth, of a capsule and a polygon near corners: "
                    "what lies within the radii beyond the reference face's ends is cut off",
                .source = "planck 1.5.0, src/collision/shape/CollideEdgePolygon.ts, "
                          "CollideEdgePolygon: sideOffset1, without the radius that "
                          "CollidePolygons adds",
                .budgets = kOfPlanckEdgeSlabNotWidened,
                .explains = planck_edge_slab_not_widened},
    LedgerEntry{.id = "planck-edge-hysteresis",
                .collider = "planck",
                .description =
                    "of a capsule and a polygon, a face that is not the least deep: the capsule's "
                    "towards the centroid, or the polygon's by 2 % of the separation",
                .source = "planck 1.5.0, src/collision/shape/CollideEdgePolygon.ts, "
                          "CollideEdgePolygon: front = offset1 >= 0.0; polygonAxis.separation > "
                          "k_relativeTol * edgeAxis.separation + k_absoluteTol",
                .budgets = kOfPlanckEdgeHysteresis,
                .explains = planck_edge_hysteresis,
                .is_no_bug = true},
    LedgerEntry{.id = "planck-axis-within-epsilon",
                .collider = "planck",
                .description = "a normal along the world's x axis: a circle's centre is within "
                               "1e-9 of another's or of an edge's end",
                .source = "planck 1.5.0, src/collision/Manifold.ts, getWorldManifold: "
                          "lengthSqr > EPSILON * EPSILON; src/common/Math.ts: EPSILON = 1e-9",
                .budgets = kOfPlanckAxisWithinEpsilon,
                .explains = axis_within_planck_epsilon},
    LedgerEntry{.id = "planck-face-within-epsilon",
                .collider = "planck",
                .description = "a face's normal beyond its corner: a circle's centre is within "
                               "1e-9 of a polygon",
                .source = "planck 1.5.0, src/collision/shape/CollideCirclePolygon.ts, "
                          "CollidePolygonCircle: separation < EPSILON",
                .budgets = kOfPlanckFaceWithinEpsilon,
                .explains = face_within_planck_epsilon},
    LedgerEntry{.id = "planck-no-contact-under-bias",
                .collider = "planck",
                .description =
                    "no contact for overlapping polygons: A's face is preferred though B's is "
                    "less deep, and the incident edge lies outside its side planes",
                .source = "planck 1.5.0, src/collision/shape/CollidePolygon.ts, CollidePolygons: "
                          "k_tol = 0.1 * Settings.linearSlop, then `if (np1 < 2) return`",
                .budgets = kOfPlanckNoContactUnderBias,
                .explains = no_contact_under_bias},
    LedgerEntry{.id = "planck-no-contact-on-tied-features",
                .collider = "planck",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in double, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source = "planck 1.5.0, src/collision/shape/CollidePolygon.ts, findMaxSeparation "
                          "and findIncidentEdge: first of equals",
                .budgets = kOfPlanckNoContactOnTiedFeatures,
                .explains = no_contact_on_tied_features},
};

}  // namespace manifuzz::ledger_of
