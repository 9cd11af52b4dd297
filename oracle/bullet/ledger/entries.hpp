#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/bullet/ledger/query_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, in float. Budgets are twice what 1,000,000 cases against clip64 showed, rounded up.

inline constexpr std::string_view kDirectionOfPoints =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "tmpNormalInB = tmpPointOnB - tmpPointOnA";
inline constexpr std::string_view kSignOfDistance =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "distance2 = -(tmpPointOnA - tmpPointOnB).length()";
inline constexpr std::string_view kFixedDirections =
    "Bullet 3.24, btMinkowskiPenetrationDepthSolver.cpp, calcPenDepth: "
    "`just take fixed number of orientation`";
inline constexpr std::string_view kEqualVertices =
    "Bullet 3.24, btVoronoiSimplexSolver.cpp, inSimplex: distance2 <= m_equalVertexThreshold, "
    "0.0001";
inline constexpr Budget kOfBulletEpaDirectionOfRoundings[] = {{"generic", 420000},
                                                              {"boxes", 400000},
                                                              {"regular", 390000},
                                                              {"grid", 510000},
                                                              {"sliver", 380000},
                                                              {"near_parallel", 250000},
                                                              {"tied_faces", 180000},
                                                              {"micro_edge", 140000},
                                                              {"near_collinear", 260000},
                                                              {"corner_corner", 230000},
                                                              {"corner_face", 240000},
                                                              {"touching", 1000000},
                                                              {"tie_bias", 370000},
                                                              {"far_from_origin", 200000},
                                                              {"scaled", 200000},
                                                              {"off_unit", 330000},
                                                              {"ulp", 330000},
                                                              {"capsules", 17000},
                                                              {"round_corners", 5600},
                                                              {"mixed_shapes", 24000},
                                                              {"in_line", 4900},
                                                              {"tilted_edges", 6800},
                                                              {"voronoi_lines", 3700},
                                                              {"cores_touch", 8400},
                                                              {"large_radii", 9600},
                                                              {"side_planes", 7900}};
inline constexpr Budget kOfBulletEpaLeastDistance[] = {
    {"generic", 58000},        {"boxes", 44000},
    {"regular", 45000},        {"sliver", 110000},
    {"near_parallel", 80000},  {"tied_faces", 68000},
    {"micro_edge", 90000},     {"near_collinear", 76000},
    {"corner_corner", 48000},  {"corner_face", 69000},
    {"touching", 4500},        {"tie_bias", 62000},
    {"far_from_origin", 6700}, {"scaled", 49000},
    {"off_unit", 5600},        {"ulp", 44000},
    {"capsules", 4200},        {"round_corners", 1400},
    {"mixed_shapes", 6800},    {"in_line", 130},
    {"tilted_edges", 2300},    {"voronoi_lines", 550},
    {"cores_touch", 370},      {"large_radii", 1300},
    {"side_planes", 1600}};
inline constexpr Budget kOfBulletMinkowskiFixedDirections[] = {
    {"generic", 1000000},      {"boxes", 1000000},        {"regular", 1000000},
    {"grid", 730000},          {"sliver", 1000000},       {"near_parallel", 860000},
    {"tied_faces", 1000000},   {"micro_edge", 860000},    {"near_collinear", 840000},
    {"corner_corner", 550000}, {"corner_face", 780000},   {"touching", 1000000},
    {"deep", 1000000},         {"tie_bias", 1000000},     {"far_from_origin", 690000},
    {"scaled", 760000},        {"off_unit", 1000000},     {"ulp", 1000000},
    {"capsules", 130000},      {"round_corners", 160000}, {"mixed_shapes", 150000},
    {"in_line", 440000},       {"tilted_edges", 87000},   {"voronoi_lines", 49000},
    {"cores_touch", 790000},   {"large_radii", 6200},     {"side_planes", 69000}};
inline constexpr Budget kOfBulletMinkowskiDirectionOfRoundings[] = {
    {"generic", 240},       {"boxes", 180},          {"regular", 420},
    {"sliver", 4700},       {"near_parallel", 600},  {"tied_faces", 1200},
    {"micro_edge", 3400},   {"near_collinear", 240}, {"corner_corner", 600},
    {"touching", 250},      {"tie_bias", 970},       {"far_from_origin", 4600},
    {"scaled", 1300},       {"off_unit", 2100},      {"ulp", 1300},
    {"capsules", 8000},     {"round_corners", 8100}, {"mixed_shapes", 7000},
    {"in_line", 8600},      {"tilted_edges", 13000}, {"voronoi_lines", 7900},
    {"cores_touch", 11000}, {"large_radii", 7500},   {"side_planes", 12000}};
inline constexpr Budget kOfBulletMinkowskiGapAsDepth[] = {
    {"generic", 9100},       {"boxes", 7200},
    {"regular", 8500},       {"sliver", 5400},
    {"near_parallel", 5600}, {"tied_faces", 3200},
    {"micro_edge", 3300},    {"near_collinear", 4100},
    {"corner_corner", 960},  {"corner_face", 3800},
    {"touching", 61},        {"deep", 61},
    {"tie_bias", 2300},      {"far_from_origin", 2000},
    {"scaled", 4800},        {"off_unit", 6400},
    {"ulp", 4400},           {"capsules", 190},
    {"round_corners", 130},  {"mixed_shapes", 430},
    {"in_line", 61},         {"tilted_edges", 310},
    {"side_planes", 61}};
inline constexpr Budget kOfBulletMinkowskiEqualVertices[] = {
    {"sliver", 1500},      {"tied_faces", 3300}, {"micro_edge", 48000}, {"near_collinear", 180},
    {"corner_corner", 60}, {"deep", 33000},      {"scaled", 400000},    {"ulp", 27000},
    {"cores_touch", 1700}, {"large_radii", 430}};
inline constexpr Budget kOfBulletConvex2dFlattenedDirections[] = {
    {"generic", 1000000},      {"boxes", 1000000},        {"regular", 1000000},
    {"grid", 1000000},         {"sliver", 1000000},       {"near_parallel", 890000},
    {"tied_faces", 1000000},   {"micro_edge", 900000},    {"near_collinear", 890000},
    {"corner_corner", 740000}, {"corner_face", 890000},   {"touching", 1000000},
    {"deep", 1000000},         {"tie_bias", 1000000},     {"far_from_origin", 760000},
    {"scaled", 770000},        {"off_unit", 1000000},     {"ulp", 1000000},
    {"capsules", 140000},      {"round_corners", 170000}, {"mixed_shapes", 160000},
    {"in_line", 410000},       {"tilted_edges", 89000},   {"voronoi_lines", 56000},
    {"cores_touch", 940000},   {"large_radii", 45000},    {"side_planes", 79000}};
inline constexpr Budget kOfBulletConvex2dDirectionOfRoundings[] = {
    {"generic", 2500},         {"boxes", 1200},
    {"regular", 2000},         {"sliver", 16000},
    {"near_parallel", 3500},   {"tied_faces", 3700},
    {"micro_edge", 3000},      {"near_collinear", 2100},
    {"corner_corner", 1500},   {"corner_face", 1600},
    {"touching", 2100},        {"tie_bias", 2500},
    {"far_from_origin", 8500}, {"scaled", 3400},
    {"off_unit", 11000},       {"ulp", 3300},
    {"capsules", 6400},        {"round_corners", 2700},
    {"mixed_shapes", 4400},    {"in_line", 9400},
    {"tilted_edges", 7600},    {"voronoi_lines", 15000},
    {"cores_touch", 12000},    {"large_radii", 13000},
    {"side_planes", 13000}};
inline constexpr Budget kOfBulletConvex2dGapAsDepth[] = {
    {"generic", 12000},      {"boxes", 9000},
    {"regular", 11000},      {"sliver", 6300},
    {"near_parallel", 4900}, {"tied_faces", 4200},
    {"micro_edge", 1400},    {"near_collinear", 4100},
    {"corner_corner", 540},  {"corner_face", 5000},
    {"touching", 310},       {"deep", 61},
    {"tie_bias", 1500},      {"far_from_origin", 1900},
    {"scaled", 4100},        {"off_unit", 4300},
    {"ulp", 3800},           {"capsules", 130},
    {"mixed_shapes", 370},   {"tilted_edges", 61},
    {"side_planes", 61}};
inline constexpr Budget kOfBulletConvex2dEqualVertices[] = {
    {"sliver", 960},         {"tied_faces", 2700}, {"micro_edge", 95000},
    {"near_collinear", 420}, {"deep", 2900},       {"scaled", 420000},
    {"ulp", 27000},          {"cores_touch", 61},  {"large_radii", 29000}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfBullet{
    LedgerEntry{.id = "bullet-epa-direction-of-roundings",
                .collider = "bullet-epa",
                .description = "a shallow contact's normal is the direction between two points, "
                               "roundings of which are as long",
                .source = kDirectionOfPoints,
                .budgets = kOfBulletEpaDirectionOfRoundings,
                .explains = by_query<BulletAsked::epa, direction_of_short_translation>},
    LedgerEntry{.id = "bullet-epa-least-distance",
                .collider = "bullet-epa",
                .description = "overlap, gap and touch within 0.0001 are not told apart",
                .source = "Bullet 3.24, btGjkEpa2.cpp, GJK::Evaluate: rl < GJK_MIN_DISTANCE is "
                          "Inside",
                .budgets = kOfBulletEpaLeastDistance,
                .explains = epa_below_least_distance},
    LedgerEntry{.id = "bullet-minkowski-fixed-directions",
                .collider = "bullet-minkowski",
                .description = "the normal is one of ten in the plane, 36 degrees apart, and the "
                               "depth that of a query beside it",
                .source = kFixedDirections,
                .budgets = kOfBulletMinkowskiFixedDirections,
                .explains = by_query<BulletAsked::directions, least_of_fixed_directions>,
                .is_no_bug = true},
    LedgerEntry{.id = "bullet-minkowski-direction-of-roundings",
                .collider = "bullet-minkowski",
                .description = "a shallow contact's normal is the direction between two points, "
                               "roundings of which are as long",
                .source = kDirectionOfPoints,
                .budgets = kOfBulletMinkowskiDirectionOfRoundings,
                .explains = by_query<BulletAsked::directions, direction_of_short_translation>},
    LedgerEntry{.id = "bullet-minkowski-gap-as-depth",
                .collider = "bullet-minkowski",
                .description = "contact for shapes apart, the gap's width as the depth",
                .source = kSignOfDistance,
                .budgets = kOfBulletMinkowskiGapAsDepth,
                .explains = by_solver<BulletAsked::directions, gap_as_depth>},
    LedgerEntry{
        .id = "bullet-minkowski-equal-vertices",
        .collider = "bullet-minkowski",
        .description = "contact for shapes apart, a depth smaller than the gap's width: corners "
                       "nearer than 0.01 are one",
        .source = kEqualVertices,
        .budgets = kOfBulletMinkowskiEqualVertices,
        .explains = by_query<BulletAsked::directions, least_of_fixed_directions_of_equal_vertices>},
    LedgerEntry{.id = "bullet-convex2d-flattened-directions",
                .collider = "bullet-convex2d",
                .description = "a direction that is shorter than 1 without its z is taken to have "
                               "the least depth, and the displaced shapes may still overlap",
                .source = "Bullet 3.24, btMinkowskiPenetrationDepthSolver.cpp, calcPenDepth: "
                          "norm[2] = 0.f where check2d",
                .budgets = kOfBulletConvex2dFlattenedDirections,
                .explains = by_query<BulletAsked::flat, least_of_flattened_directions>},
    LedgerEntry{.id = "bullet-convex2d-direction-of-roundings",
                .collider = "bullet-convex2d",
                .description = "a shallow contact's normal is the direction between two points, "
                               "roundings of which are as long",
                .source = kDirectionOfPoints,
                .budgets = kOfBulletConvex2dDirectionOfRoundings,
                .explains = by_query<BulletAsked::flat, direction_of_short_translation>},
    LedgerEntry{.id = "bullet-convex2d-gap-as-depth",
                .collider = "bullet-convex2d",
                .description = "contact for shapes apart, the gap's width as the depth",
                .source = kSignOfDistance,
                .budgets = kOfBulletConvex2dGapAsDepth,
                .explains = by_solver<BulletAsked::flat, gap_as_depth>},
    LedgerEntry{
        .id = "bullet-convex2d-equal-vertices",
        .collider = "bullet-convex2d",
        .description = "contact for shapes apart, a depth smaller than the gap's width: corners "
                       "nearer than 0.01 are one",
        .source = kEqualVertices,
        .budgets = kOfBulletConvex2dEqualVertices,
        .explains = by_query<BulletAsked::flat, least_of_flattened_directions_of_equal_vertices>},
};

}  // namespace manifuzz::ledger_of
