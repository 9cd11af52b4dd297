#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/p2-es/deviations.hpp"

namespace manifuzz::ledger_of {

// p2-es 1.2.3. Budgets (budgets.json) are twice what 300,000 cases against clip64 showed, of
// normals of float vertices and circles without contact another 300,000, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfP2{
    LedgerEntry{.id = "p2-es-no-contact-on-tied-features",
                .collider = "p2-es",
                .description = "no contact for overlapping polygons: faces or edges tie in float, "
                               "the wrong one is kept, and its slab misses the deepest vertex",
                .source = "p2-es 1.2.3, dist/p2-es.js, findMaxSeparation and findIncidentEdge: the "
                          "first of what floats cannot tell apart; convexConvex: `if (np < 2)`",
                .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "p2-es-zero-normal",
                .collider = "p2-es",
                .description = "a normal without length, and no depth: a circle's centre is on "
                               "another's, or on a capsule's core",
                .source = "p2-es 1.2.3, dist/p2-es.js, normalize: `if (len > 0)`; circleCircle: "
                          "normalize(normalA, normalA); circleLine: scale(c.normalA, orthoDist, "
                          "-1)",
                .explains = zero_normal_of_p2},
    LedgerEntry{.id = "p2-es-direction-of-roundings",
                .collider = "p2-es",
                .description = "a circle's centre on a capsule's core, but for roundings: the "
                               "sign of the normal is theirs, and that of the capsule's radius; "
                               "at an end its direction",
                .source = "p2-es 1.2.3, dist/p2-es.js, circleLine: d = dot(dist, worldTangent), "
                          "normalize(lineToCircleOrthoUnit, lineToCircleOrthoUnit)",
                .explains = direction_of_roundings_of_p2},
    LedgerEntry{.id = "p2-es-first-end",
                .collider = "p2-es",
                .description = "a capsule's first end where its second is nearer: the first within "
                               "reach is taken",
                .source = "p2-es 1.2.3, dist/p2-es.js, circleLine: `return 1` in the loop over "
                          "verts",
                .explains = first_end_of_p2},
    LedgerEntry{.id = "p2-es-edge-of-rounded-ends",
                .collider = "p2-es",
                .description =
                    "a capsule's normal off by the roundoff of its ends over its length: "
                    "its direction is that of its ends as floats have them in the world",
                .source = "p2-es 1.2.3, dist/p2-es.js, circleLine: subtract(worldEdge, "
                          "worldVertex1, worldVertex0), of Float32Arrays",
                .explains = edge_of_rounded_ends_in_p2},
    LedgerEntry{.id = "p2-es-face-before-vertex",
                .collider = "p2-es",
                .description = "a face's contact where a circle is nearest to a vertex, or to "
                               "another face: the circle's point along the face's normal is "
                               "inside the polygon, and least deep there",
                .source = "p2-es 1.2.3, dist/p2-es.js, circleConvex: `Check edges first`",
                .explains = face_before_vertex_of_p2},
    LedgerEntry{.id = "p2-es-vertex-before-face",
                .collider = "p2-es",
                .description = "a vertex' contact, or none, where a circle is nearest to a face: "
                               "the circle's point along the face's normal is outside the "
                               "polygon, behind its far side",
                .source = "p2-es 1.2.3, dist/p2-es.js, circleConvex: "
                          "pointInConvexLocal(candidate, convexShape)",
                .explains = vertex_before_face_of_p2},
};

}  // namespace manifuzz::ledger_of
