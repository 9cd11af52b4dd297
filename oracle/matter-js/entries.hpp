#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/matter-js/deviations.hpp"

namespace manifuzz::ledger_of {

// matter-js 0.20.0. Budgets (budgets.json) are twice what 300,000 cases against clip64 showed,
// rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfMatter{
    LedgerEntry{.id = "matter-js-normal-by-centres",
                .collider = "matter-js",
                .description = "a normal the wrong way: its sign comes from the centres of mass "
                               "and not from the overlap that is least",
                .source = "matter-js 0.20.0, src/collision/Collision.js, collides: "
                          "normalX * deltaX + normalY * deltaY >= 0",
                .explains = normal_by_matter_centres},
    LedgerEntry{.id = "matter-js-axes-merged",
                .collider = "matter-js",
                .description = "another face's normal and overlap: of faces whose gradients agree "
                               "to three decimals only the last is an axis",
                .source = "matter-js 0.20.0, src/geometry/Axes.js, fromVertices: "
                          "gradient.toFixed(3)",
                .explains = axes_merged_by_matter},
    LedgerEntry{.id = "matter-js-vertex-outside",
                .collider = "matter-js",
                .description = "a point outside of the overlap: no support vertex is inside the "
                               "other body, and A's is given",
                .source = "matter-js 0.20.0, src/collision/Collision.js, collides: "
                          "supports[supportCount++] = supportsB[0], which is _supports, by "
                          "then A's",
                .explains = vertex_outside_by_matter},
    LedgerEntry{.id = "matter-js-deepest-left-out",
                .collider = "matter-js",
                .description = "no point as deep as said: the deepest vertex sticks out of the "
                               "other's far side, or A's are not asked where two of B's are inside",
                .source = "matter-js 0.20.0, src/collision/Collision.js, collides: "
                          "Vertices.contains(bodyA.vertices, supportsB[0]); supportCount < 2",
                .explains = deepest_left_out_by_matter},
    LedgerEntry{.id = "matter-js-neighbour-by-depth",
                .collider = "matter-js",
                .description = "too few points, too near each other, or one on a far side: the "
                               "deeper neighbour of the deepest vertex is taken, not the end of "
                               "the edge that faces the other body",
                .source = "matter-js 0.20.0, src/collision/Collision.js, _findSupports: "
                          "`compare with previous vertex`",
                .explains = neighbour_by_depth_of_matter},
    LedgerEntry{.id = "matter-js-vertices-inside-alone",
                .collider = "matter-js",
                .description = "too few points, or too near each other: only ends of both edges "
                               "that are inside the other body, and no place where one is cut",
                .source = "matter-js 0.20.0, src/collision/Collision.js, collides: "
                          "Vertices.contains of both bodies' supports",
                .explains = vertices_inside_alone_by_matter,
                .is_no_bug = true},
};

}  // namespace manifuzz::ledger_of
