#pragma once

#include <array>

#include "oracle/bullet/ledger/query_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, its query repeated in float. Budgets are twice what 300,000 cases against clip64
// showed, or 1,000,000 where those show more, rounded up.

inline constexpr std::string_view kDetectorKeepsAxis =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "newCachedSeparatingAxis.length2() < REL_ERROR2, then distance2 < distance, or d2 > distance";
inline constexpr std::string_view kNearCorner =
    "Bullet 3.24, btVoronoiSimplexSolver.cpp, inSimplex: distance2(w) <= "
    "m_equalVertexThreshold, 0.0001";
inline constexpr std::string_view kRelativeErrorEnds =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: f0 <= f1, f1 = "
    "squaredDistance * REL_ERROR2; or previousSquaredDistance - squaredDistance <= SIMD_EPSILON; "
    "or inSimplex(w) before, w being farthest as rounded products tell";
inline constexpr std::string_view kFlatSimplex =
    "Bullet 3.24, btVoronoiSimplexSolver.cpp, pointOutsideOfPlane: signd * signd < "
    "(1e-4) * (1e-4); updateClosestVectorAndPoints: isValid";
inline constexpr std::string_view kDetectorAxis =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "normalInB = m_cachedSeparatingAxis";
inline constexpr std::string_view kDisplacedPoint =
    "Bullet 3.24, btMinkowskiPenetrationDepthSolver.cpp, calcPenDepth: "
    "pb = res.m_pointInWorld, v = minNorm";

inline constexpr Budget kOfBulletMinkowskiTouchingAxis[] = {
    {"boxes", 58000},           {"capsules", 7200},     {"cores_touch", 440000},
    {"corner_corner", 13000},   {"corner_face", 49000}, {"deep", 1000},
    {"far_from_origin", 34000}, {"generic", 75000},     {"in_line", 110000},
    {"micro_edge", 30000},      {"mixed_shapes", 9000}, {"near_collinear", 82000},
    {"near_parallel", 96000},   {"off_unit", 67000},    {"regular", 72000},
    {"round_corners", 7200},    {"scaled", 28000},      {"side_planes", 9600},
    {"sliver", 270000},         {"tie_bias", 42000},    {"tied_faces", 69000},
    {"tilted_edges", 8800},     {"touching", 96000},    {"ulp", 65000},
    {"voronoi_lines", 2000}};
inline constexpr Budget kOfBulletMinkowskiNearCorner[] = {
    {"deep", 170000},        {"large_radii", 2400}, {"micro_edge", 47000},
    {"near_collinear", 200}, {"scaled", 71000},     {"side_planes", 400},
    {"sliver", 2200},        {"tied_faces", 10000}, {"ulp", 17000}};
inline constexpr Budget kOfBulletMinkowskiRelativeError[] = {
    {"cores_touch", 1000},     {"corner_corner", 720}, {"deep", 200},
    {"far_from_origin", 1400}, {"in_line", 400},       {"large_radii", 27000},
    {"micro_edge", 7800},      {"mixed_shapes", 400},  {"near_parallel", 540},
    {"off_unit", 600},         {"scaled", 670},        {"side_planes", 1000},
    {"sliver", 540},           {"tie_bias", 1900},     {"tied_faces", 2200},
    {"touching", 250},         {"ulp", 910},           {"voronoi_lines", 1800},
    {"capsules", 190},         {"circles", 190},       {"corner_face", 61},
    {"near_collinear", 360},   {"round_corners", 61},  {"tilted_edges", 130}};
inline constexpr Budget kOfBulletMinkowskiFlatSimplex[] = {{"capsules", 800},
                                                           {"cores_touch", 13000},
                                                           {"corner_corner", 360},
                                                           {"deep", 12000},
                                                           {"far_from_origin", 1100},
                                                           {"in_line", 4700},
                                                           {"large_radii", 6200},
                                                           {"micro_edge", 2600},
                                                           {"mixed_shapes", 400},
                                                           {"near_collinear", 16000},
                                                           {"near_parallel", 19000},
                                                           {"off_unit", 670},
                                                           {"round_corners", 1400},
                                                           {"scaled", 28000},
                                                           {"side_planes", 200},
                                                           {"sliver", 20000},
                                                           {"tie_bias", 1700},
                                                           {"tied_faces", 19000},
                                                           {"tilted_edges", 1800},
                                                           {"touching", 1100},
                                                           {"ulp", 6400},
                                                           {"boxes", 60},
                                                           {"circles", 61},
                                                           {"corner_face", 490},
                                                           {"generic", 180},
                                                           {"grid", 60},
                                                           {"regular", 60},
                                                           {"voronoi_lines", 490}};
inline constexpr Budget kOfBulletMinkowskiDisplacedPoint[] = {{"cores_touch", 3000},
                                                              {"corner_corner", 27000},
                                                              {"corner_face", 200},
                                                              {"deep", 200},
                                                              {"far_from_origin", 9400},
                                                              {"in_line", 200},
                                                              {"micro_edge", 12000},
                                                              {"mixed_shapes", 200},
                                                              {"near_collinear", 1600},
                                                              {"near_parallel", 1800},
                                                              {"off_unit", 3200},
                                                              {"regular", 400},
                                                              {"scaled", 400},
                                                              {"sliver", 2400},
                                                              {"tie_bias", 29000},
                                                              {"tied_faces", 12000},
                                                              {"tilted_edges", 200},
                                                              {"touching", 800},
                                                              {"ulp", 5600}};
inline constexpr Budget kOfBulletMinkowskiAxisOfRoundings[] = {
    {"capsules", 250},       {"cores_touch", 12000}, {"far_from_origin", 250},
    {"in_line", 5000},       {"large_radii", 200},   {"mixed_shapes", 400},
    {"round_corners", 1000}, {"side_planes", 200},   {"tilted_edges", 550},
    {"corner_corner", 120},  {"corner_face", 61},    {"micro_edge", 420},
    {"near_collinear", 180}, {"near_parallel", 60},  {"off_unit", 250},
    {"scaled", 61},          {"sliver", 240},        {"tie_bias", 850},
    {"tied_faces", 840},     {"touching", 370},      {"ulp", 250},
    {"voronoi_lines", 61}};
inline constexpr Budget kOfBulletConvex2dTouchingAxis[] = {{"boxes", 100000},
                                                           {"capsules", 8000},
                                                           {"cores_touch", 560000},
                                                           {"corner_corner", 9400},
                                                           {"corner_face", 49000},
                                                           {"deep", 39000},
                                                           {"far_from_origin", 46000},
                                                           {"generic", 110000},
                                                           {"grid", 11000},
                                                           {"in_line", 170000},
                                                           {"micro_edge", 30000},
                                                           {"mixed_shapes", 10000},
                                                           {"near_collinear", 74000},
                                                           {"near_parallel", 89000},
                                                           {"off_unit", 65000},
                                                           {"regular", 110000},
                                                           {"round_corners", 8600},
                                                           {"scaled", 56000},
                                                           {"side_planes", 8200},
                                                           {"sliver", 270000},
                                                           {"tie_bias", 38000},
                                                           {"tied_faces", 60000},
                                                           {"tilted_edges", 7600},
                                                           {"touching", 230000},
                                                           {"ulp", 84000},
                                                           {"voronoi_lines", 2800}};
inline constexpr Budget kOfBulletConvex2dNearCorner[] = {
    {"cores_touch", 1800}, {"deep", 170000},         {"large_radii", 190000}, {"micro_edge", 53000},
    {"mixed_shapes", 200}, {"near_collinear", 1000}, {"scaled", 15000},       {"side_planes", 200},
    {"sliver", 3200},      {"tied_faces", 24000},    {"ulp", 17000}};
inline constexpr Budget kOfBulletConvex2dRelativeError[] = {
    {"cores_touch", 1000},  {"in_line", 1200},       {"large_radii", 910},  {"near_collinear", 400},
    {"round_corners", 200}, {"scaled", 400},         {"side_planes", 2000}, {"sliver", 200},
    {"ulp", 200},           {"voronoi_lines", 4300}, {"boxes", 60},         {"capsules", 61},
    {"corner_corner", 60},  {"near_parallel", 60},   {"tie_bias", 61},      {"tied_faces", 360},
    {"tilted_edges", 310}};
inline constexpr Budget kOfBulletConvex2dFlatSimplex[] = {
    {"cores_touch", 1200}, {"off_unit", 200}, {"scaled", 7200}, {"ulp", 600}};
inline constexpr Budget kOfBulletConvex2dDisplacedPoint[] = {
    {"cores_touch", 600},      {"corner_corner", 9800},
    {"far_from_origin", 3800}, {"in_line", 400},
    {"micro_edge", 4400},      {"near_collinear", 1800},
    {"near_parallel", 6200},   {"off_unit", 1000},
    {"regular", 200},          {"sliver", 2600},
    {"tie_bias", 15000},       {"tied_faces", 22000},
    {"tilted_edges", 200},     {"ulp", 2400}};
inline constexpr Budget kOfBulletConvex2dAxisOfRoundings[] = {
    {"capsules", 200},      {"cores_touch", 8600}, {"in_line", 7800},     {"scaled", 3800},
    {"side_planes", 200},   {"sliver", 2200},      {"boxes", 420},        {"far_from_origin", 430},
    {"generic", 480},       {"micro_edge", 180},   {"mixed_shapes", 61},  {"near_collinear", 180},
    {"near_parallel", 720}, {"off_unit", 790},     {"round_corners", 61}, {"tied_faces", 180},
    {"tilted_edges", 250},  {"touching", 1200},    {"ulp", 550}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletQuery{
    LedgerEntry{.id = "bullet-minkowski-touching-axis",
                .collider = "bullet-minkowski",
                .description =
                    "cores within 0.001 of touching: the loop ends before it renews the "
                    "distance, so the normal is that of two points that nearly coincide, and "
                    "the point is moved to the surface by the step before's distance",
                .source = kDetectorKeepsAxis,
                .budgets = kOfBulletMinkowskiTouchingAxis,
                .explains = axis_of_touching_cores<BulletAsked::directions>},
    LedgerEntry{
        .id = "bullet-minkowski-near-corner",
        .collider = "bullet-minkowski",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .budgets = kOfBulletMinkowskiNearCorner,
        .explains = stopped_at_near_corner<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-minkowski-relative-error",
                .collider = "bullet-minkowski",
                .description = "the query ends where its squared distance, 1e18 at first, falls by "
                               "less than a millionth",
                .source = kRelativeErrorEnds,
                .budgets = kOfBulletMinkowskiRelativeError,
                .explains = stopped_by_relative_error<BulletAsked::directions>},
    LedgerEntry{
        .id = "bullet-minkowski-flat-simplex",
        .collider = "bullet-minkowski",
        .description = "the query ends at four corners in a plane, within 0.0001 of a determinant",
        .source = kFlatSimplex,
        .budgets = kOfBulletMinkowskiFlatSimplex,
        .explains = stopped_at_flat_simplex<BulletAsked::directions>},
    LedgerEntry{
        .id = "bullet-minkowski-displaced-point",
        .collider = "bullet-minkowski",
        .description = "the point is that of a query beside it, whose direction is not the normal",
        .source = kDisplacedPoint,
        .budgets = kOfBulletMinkowskiDisplacedPoint,
        .explains = point_of_displaced_query<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-minkowski-axis-of-roundings",
                .collider = "bullet-minkowski",
                .description = "the direction between the closest points of cores so near that the "
                               "roundings of these turn it",
                .source = kDetectorAxis,
                .budgets = kOfBulletMinkowskiAxisOfRoundings,
                .explains = axis_turned_by_roundings<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-convex2d-touching-axis",
                .collider = "bullet-convex2d",
                .description =
                    "cores within 0.001 of touching: the loop ends before it renews the "
                    "distance, so the normal is that of two points that nearly coincide, and "
                    "the point is moved to the surface by the step before's distance",
                .source = kDetectorKeepsAxis,
                .budgets = kOfBulletConvex2dTouchingAxis,
                .explains = axis_of_touching_cores<BulletAsked::flat>},
    LedgerEntry{
        .id = "bullet-convex2d-near-corner",
        .collider = "bullet-convex2d",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .budgets = kOfBulletConvex2dNearCorner,
        .explains = stopped_at_near_corner<BulletAsked::flat>},
    LedgerEntry{.id = "bullet-convex2d-relative-error",
                .collider = "bullet-convex2d",
                .description = "the query ends where its squared distance, 1e18 at first, falls by "
                               "less than a millionth",
                .source = kRelativeErrorEnds,
                .budgets = kOfBulletConvex2dRelativeError,
                .explains = stopped_by_relative_error<BulletAsked::flat>},
    LedgerEntry{
        .id = "bullet-convex2d-flat-simplex",
        .collider = "bullet-convex2d",
        .description = "the query ends at four corners in a plane, within 0.0001 of a determinant",
        .source = kFlatSimplex,
        .budgets = kOfBulletConvex2dFlatSimplex,
        .explains = stopped_at_flat_simplex<BulletAsked::flat>},
    LedgerEntry{
        .id = "bullet-convex2d-displaced-point",
        .collider = "bullet-convex2d",
        .description = "the point is that of a query beside it, whose direction is not the normal",
        .source = kDisplacedPoint,
        .budgets = kOfBulletConvex2dDisplacedPoint,
        .explains = point_of_displaced_query<BulletAsked::flat>},
    LedgerEntry{.id = "bullet-convex2d-axis-of-roundings",
                .collider = "bullet-convex2d",
                .description = "the direction between the closest points of cores so near that the "
                               "roundings of these turn it",
                .source = kDetectorAxis,
                .budgets = kOfBulletConvex2dAxisOfRoundings,
                .explains = axis_turned_by_roundings<BulletAsked::flat>},
};

}  // namespace manifuzz::ledger_of
