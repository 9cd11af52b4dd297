#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d/deviations.hpp"

namespace manifuzz::ledger_of {

// Box2D 2.4.1. Budgets (budgets.json) are twice what 20,000,000 cases showed, of round
// shapes 8,400,000, rounded up. An entry without
// budgets is met in the regime `corpus` alone, which has none.

/// The entries, the first that explains before others.
inline constexpr std::array kOfBox2d{
    LedgerEntry{.id = "box2d-tiny-reference-face",
                .collider = "box2d",
                .description =
                    "a wrong normal or no contact: the reference face is shorter than b2_epsilon, "
                    "so its direction is not normalised, or than world coordinates resolve",
                .source = "Box2D 2.4.1, include/box2d/b2_math.h, b2Vec2::Normalize: `if (length < "
                          "b2_epsilon) return 0.0f`; src/collision/b2_collide_polygon.cpp, "
                          "b2CollidePolygons: side offsets of world vertices",
                .explains = tiny_reference_face_of_box2d},
    LedgerEntry{.id = "box2d-huge-reference-face",
                .collider = "box2d",
                .description =
                    "a normal of length zero: the square of the reference face's length is beyond "
                    "float, so its direction is divided by infinity",
                .source = "Box2D 2.4.1, include/box2d/b2_math.h, b2Vec2::Length and Normalize: "
                          "`b2Sqrt(x * x + y * y)`",
                .explains = huge_reference_face},
    LedgerEntry{.id = "box2d-no-contact-under-bias",
                .collider = "box2d",
                .description =
                    "no contact for overlapping polygons: A's face is preferred though B's is "
                    "less deep, and the incident edge lies outside its side planes",
                .source = "Box2D 2.4.1, src/collision/b2_collide_polygon.cpp, b2CollidePolygons: "
                          "k_tol = 0.1f * b2_linearSlop, then `if (np < 2) return`",
                .explains = no_contact_under_bias},
    LedgerEntry{.id = "box2d-no-contact-on-tied-features",
                .collider = "box2d",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in float, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source = "Box2D 2.4.1, src/collision/b2_collide_polygon.cpp, b2FindMaxSeparation "
                          "and b2FindIncidentEdge: first of equals",
                .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "box2d-crossing-underflows",
                .collider = "box2d",
                .description =
                    "no contact for overlapping polygons: an end of the incident edge all "
                    "but touches a side plane, the product of distances underflows",
                .source = "Box2D 2.4.1, src/collision/b2_collision.cpp, b2ClipSegmentToLine: `if "
                          "(distance0 * distance1 < 0.0f)`",
                .explains = crossing_underflows},
    LedgerEntry{.id = "box2d-edge-slab-not-widened",
                .collider = "box2d",
                .description =
                    "no contact, or too little depth, of a capsule and a polygon near corners: "
                    "what lies within the radii beyond the reference face's ends is cut off",
                .source = "Box2D 2.4.1, src/collision/b2_collide_edge.cpp, "
                          "b2CollideEdgeAndPolygon: ref.sideOffset1 = b2Dot(ref.sideNormal1, "
                          "ref.v1), without the radius that b2CollidePolygons adds",
                .explains = edge_slab_not_widened},
    LedgerEntry{.id = "box2d-edge-hysteresis",
                .collider = "box2d",
                .description =
                    "a capsule's own face is kept though the polygon's is less deep, by 2 % of "
                    "its depth and 0.001",
                .source = "Box2D 2.4.1, src/collision/b2_collide_edge.cpp, "
                          "b2CollideEdgeAndPolygon: k_relativeTol = 0.98f, k_absoluteTol = 0.001f",
                .explains = edge_face_kept_by_hysteresis,
                .is_no_bug = true},
    LedgerEntry{.id = "box2d-coincident-points",
                .collider = "box2d",
                .description = "a normal along the world's x axis, into the edge: a circle's "
                               "centre lies on the end of an edge",
                .source = "Box2D 2.4.1, src/collision/b2_collision.cpp, "
                          "b2WorldManifold::Initialize: normal.Set(1.0f, 0.0f)",
                .explains = axis_for_coincident_points},
    LedgerEntry{.id = "box2d-direction-of-roundings",
                .collider = "box2d",
                .description = "a normal into the core: a circle's centre lies on an edge's end or "
                               "a polygon's corner, but for roundings, and their direction is it",
                .source =
                    "Box2D 2.4.1, src/collision/b2_collision.cpp, b2WorldManifold::Initialize: "
                    "normal = pointB - pointA; src/collision/b2_collide_circle.cpp, "
                    "b2CollidePolygonAndCircle: localNormal = cLocal - v1",
                .explains = direction_of_roundings},
    LedgerEntry{.id = "box2d-corner-direction-not-normalised",
                .collider = "box2d",
                .description = "a normal of no length and no depth: a circle's centre lies on a "
                               "polygon's corner, or within epsilon of it",
                .source = "Box2D 2.4.1, src/collision/b2_collide_circle.cpp, "
                          "b2CollidePolygonAndCircle: localNormal = cLocal - v1; "
                          "include/box2d/b2_math.h, b2Vec2::Normalize: `if (length < b2_epsilon)`",
                .explains = corner_direction_not_normalised},
    LedgerEntry{.id = "box2d-face-within-epsilon",
                .collider = "box2d",
                .description = "a face's normal beyond the face: a circle's centre is in front of "
                               "a polygon by less than epsilon, nearest to its corner",
                .source = "Box2D 2.4.1, src/collision/b2_collide_circle.cpp, "
                          "b2CollidePolygonAndCircle: `if (separation < b2_epsilon)`",
                .explains = face_within_box2d_epsilon},
    LedgerEntry{.id = "box2d-circle-tied-faces",
                .collider = "box2d",
                .description = "a circle's normal from the end of a face where another face is "
                               "nearest: both tie in float, and the first is kept",
                .source = "Box2D 2.4.1, src/collision/b2_collide_circle.cpp, "
                          "b2CollidePolygonAndCircle: `if (s > separation)`, in floats",
                .explains = tied_face_of_box2d_circle},
};

}  // namespace manifuzz::ledger_of
