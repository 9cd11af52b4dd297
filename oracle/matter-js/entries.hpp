#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/matter-js/deviations.hpp"

namespace manifuzz::ledger_of {

// matter-js 0.20.0. Budgets are twice what 300,000 cases against clip64 showed, rounded up.
inline constexpr Budget kOfMatterJsNormalByCentres[] = {
    {"deep", 300000}, {"near_collinear", 140}, {"scaled", 140},
    {"sliver", 6200}, {"tied_faces", 5900},    {"ulp", 22000}};
inline constexpr Budget kOfMatterJsAxesMerged[] = {
    {"corner_corner", 400},    {"corner_face", 270},   {"deep", 540},
    {"far_from_origin", 670},  {"generic", 140},       {"micro_edge", 140},
    {"near_collinear", 91000}, {"near_parallel", 270}, {"off_unit", 400},
    {"regular", 40000},        {"scaled", 400},        {"sliver", 270000},
    {"tied_faces", 160000},    {"touching", 270},      {"ulp", 46000},
    {"tie_bias", 480}};
inline constexpr Budget kOfMatterJsVertexOutside[] = {
    {"boxes", 1800},           {"corner_corner", 5800}, {"corner_face", 4000}, {"deep", 120000},
    {"far_from_origin", 4400}, {"generic", 5100},       {"grid", 4700},        {"micro_edge", 9000},
    {"near_collinear", 3000},  {"near_parallel", 2800}, {"off_unit", 4300},    {"regular", 2200},
    {"scaled", 6000},          {"sliver", 91000},       {"tie_bias", 16000},   {"tied_faces", 4300},
    {"touching", 2600},        {"ulp", 17000}};
inline constexpr Budget kOfMatterJsDeepestLeftOut[] = {
    {"boxes", 1100},          {"corner_corner", 30000},   {"corner_face", 68000},
    {"deep", 320000},         {"far_from_origin", 62000}, {"generic", 36000},
    {"grid", 12000},          {"micro_edge", 80000},      {"near_collinear", 140000},
    {"near_parallel", 63000}, {"off_unit", 68000},        {"regular", 36000},
    {"scaled", 65000},        {"sliver", 140000},         {"tie_bias", 200000},
    {"tied_faces", 240000},   {"touching", 12000},        {"ulp", 92000}};
inline constexpr Budget kOfMatterJsNeighbourByDepth[] = {
    {"boxes", 140},         {"corner_corner", 400},     {"corner_face", 20000},
    {"deep", 210000},       {"far_from_origin", 12000}, {"generic", 13000},
    {"grid", 2000},         {"micro_edge", 140000},     {"near_collinear", 70000},
    {"near_parallel", 670}, {"off_unit", 13000},        {"regular", 270},
    {"scaled", 12000},      {"sliver", 130000},         {"tie_bias", 3000},
    {"tied_faces", 8400},   {"touching", 270},          {"ulp", 37000}};
inline constexpr Budget kOfMatterJsVerticesInsideAlone[] = {
    {"boxes", 940},           {"corner_corner", 13000},   {"corner_face", 35000},
    {"deep", 60000},          {"far_from_origin", 33000}, {"generic", 15000},
    {"grid", 15000},          {"micro_edge", 69000},      {"near_collinear", 50000},
    {"near_parallel", 56000}, {"off_unit", 34000},        {"regular", 15000},
    {"scaled", 36000},        {"sliver", 47000},          {"tie_bias", 30000},
    {"tied_faces", 37000},    {"touching", 3900},         {"ulp", 34000}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfMatter{
    LedgerEntry{.id = "matter-js-normal-by-centres",
                .collider = "matter-js",
                .description = "a normal the wrong way: its sign comes from the centres of mass "
                               "and not from the overlap that is least",
                .source = "matter-js 0.20.0, src/collision/Collision.js, collides: "
                          "normalX * deltaX + normalY * deltaY >= 0",
                .budgets = kOfMatterJsNormalByCentres,
                .explains = normal_by_matter_centres},
    LedgerEntry{.id = "matter-js-axes-merged",
                .collider = "matter-js",
                .description = "another face's normal and overlap: of faces whose gradients agree "
                               "to three decimals only the last is an axis",
                .source = "matter-js 0.20.0, src/geometry/Axes.js, fromVertices: "
                          "gradient.toFixed(3)",
                .budgets = kOfMatterJsAxesMerged,
                .explains = axes_merged_by_matter},
    LedgerEntry{.id = "matter-js-vertex-outside",
                .collider = "matter-js",
                .description = "a point outside of the overlap: no support vertex is inside the "
                               "other body, and A's is given",
                .source = "matter-js 0.20.0, src/collision/Collision.js, collides: "
                          "supports[supportCount++] = supportsB[0], which is _supports, by "
                          "then A's",
                .budgets = kOfMatterJsVertexOutside,
                .explains = vertex_outside_by_matter},
    LedgerEntry{.id = "matter-js-deepest-left-out",
                .collider = "matter-js",
                .description = "no point as deep as said: the deepest vertex sticks out of the "
                               "other's far side, or A's are not asked where two of B's are inside",
                .source = "matter-js 0.20.0, src/collision/Collision.js, collides: "
                          "Vertices.contains(bodyA.vertices, supportsB[0]); supportCount < 2",
                .budgets = kOfMatterJsDeepestLeftOut,
                .explains = deepest_left_out_by_matter},
    LedgerEntry{.id = "matter-js-neighbour-by-depth",
                .collider = "matter-js",
                .description = "too few points, too near each other, or one on a far side: the "
                               "deeper neighbour of the deepest vertex is taken, not the end of "
                               "the edge that faces the other body",
                .source = "matter-js 0.20.0, src/collision/Collision.js, _findSupports: "
                          "`compare with previous vertex`",
                .budgets = kOfMatterJsNeighbourByDepth,
                .explains = neighbour_by_depth_of_matter},
    LedgerEntry{.id = "matter-js-vertices-inside-alone",
                .collider = "matter-js",
                .description = "too few points, or too near each other: only ends of both edges "
                               "that are inside the other body, and no place where one is cut",
                .source = "matter-js 0.20.0, src/collision/Collision.js, collides: "
                          "Vertices.contains of both bodies' supports",
                .budgets = kOfMatterJsVerticesInsideAlone,
                .explains = vertices_inside_alone_by_matter,
                .is_no_bug = true},
};

}  // namespace manifuzz::ledger_of
