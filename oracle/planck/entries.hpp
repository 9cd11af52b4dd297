#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d/deviations.hpp"
#include "oracle/planck/deviations.hpp"

namespace manifuzz::ledger_of {

// Budgets (budgets.json) are twice what 10,000,000 cases against clip64 showed, of round shapes
// 1,050,000, rounded up.

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
                .explains = planck_edge_slab_not_widened},
    LedgerEntry{.id = "planck-edge-hysteresis",
                .collider = "planck",
                .description =
                    "of a capsule and a polygon, a face that is not the least deep: the capsule's "
                    "towards the centroid, or the polygon's by 2 % of the separation",
                .source = "planck 1.5.0, src/collision/shape/CollideEdgePolygon.ts, "
                          "CollideEdgePolygon: front = offset1 >= 0.0; polygonAxis.separation > "
                          "k_relativeTol * edgeAxis.separation + k_absoluteTol",
                .explains = planck_edge_hysteresis,
                .is_no_bug = true},
    LedgerEntry{.id = "planck-axis-within-epsilon",
                .collider = "planck",
                .description = "a normal along the world's x axis: a circle's centre is within "
                               "1e-9 of another's or of an edge's end",
                .source = "planck 1.5.0, src/collision/Manifold.ts, getWorldManifold: "
                          "lengthSqr > EPSILON * EPSILON; src/common/Math.ts: EPSILON = 1e-9",
                .explains = axis_within_planck_epsilon},
    LedgerEntry{.id = "planck-face-within-epsilon",
                .collider = "planck",
                .description = "a face's normal beyond its corner: a circle's centre is within "
                               "1e-9 of a polygon",
                .source = "planck 1.5.0, src/collision/shape/CollideCirclePolygon.ts, "
                          "CollidePolygonCircle: separation < EPSILON",
                .explains = face_within_planck_epsilon},
    LedgerEntry{.id = "planck-no-contact-under-bias",
                .collider = "planck",
                .description =
                    "no contact for overlapping polygons: A's face is preferred though B's is "
                    "less deep, and the incident edge lies outside its side planes",
                .source = "planck 1.5.0, src/collision/shape/CollidePolygon.ts, CollidePolygons: "
                          "k_tol = 0.1 * Settings.linearSlop, then `if (np1 < 2) return`",
                .explains = no_contact_under_bias},
    LedgerEntry{.id = "planck-no-contact-on-tied-features",
                .collider = "planck",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in double, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source = "planck 1.5.0, src/collision/shape/CollidePolygon.ts, findMaxSeparation "
                          "and findIncidentEdge: first of equals",
                .explains = no_contact_on_tied_features},
};

}  // namespace manifuzz::ledger_of
