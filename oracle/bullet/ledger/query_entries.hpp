#pragma once

#include <array>

#include "oracle/bullet/ledger/query_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, its query repeated in float. Budgets (budgets.json) are twice what 300,000 cases
// against clip64 showed, or 1,000,000 where those show more, rounded up.

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

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletQuery{
    LedgerEntry{.id = "bullet-minkowski-touching-axis",
                .collider = "bullet-minkowski",
                .description =
                    "cores within 0.001 of touching: the loop ends before it renews the "
                    "distance, so the normal is that of two points that nearly coincide, and "
                    "the point is moved to the surface by the step before's distance",
                .source = kDetectorKeepsAxis,
                .explains = axis_of_touching_cores<BulletAsked::directions>},
    LedgerEntry{
        .id = "bullet-minkowski-near-corner",
        .collider = "bullet-minkowski",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .explains = stopped_at_near_corner<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-minkowski-relative-error",
                .collider = "bullet-minkowski",
                .description = "the query ends where its squared distance, 1e18 at first, falls by "
                               "less than a millionth",
                .source = kRelativeErrorEnds,
                .explains = stopped_by_relative_error<BulletAsked::directions>},
    LedgerEntry{
        .id = "bullet-minkowski-flat-simplex",
        .collider = "bullet-minkowski",
        .description = "the query ends at four corners in a plane, within 0.0001 of a determinant",
        .source = kFlatSimplex,
        .explains = stopped_at_flat_simplex<BulletAsked::directions>},
    LedgerEntry{
        .id = "bullet-minkowski-displaced-point",
        .collider = "bullet-minkowski",
        .description = "the point is that of a query beside it, whose direction is not the normal",
        .source = kDisplacedPoint,
        .explains = point_of_displaced_query<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-minkowski-axis-of-roundings",
                .collider = "bullet-minkowski",
                .description = "the direction between the closest points of cores so near that the "
                               "roundings of these turn it",
                .source = kDetectorAxis,
                .explains = axis_turned_by_roundings<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-convex2d-touching-axis",
                .collider = "bullet-convex2d",
                .description =
                    "cores within 0.001 of touching: the loop ends before it renews the "
                    "distance, so the normal is that of two points that nearly coincide, and "
                    "the point is moved to the surface by the step before's distance",
                .source = kDetectorKeepsAxis,
                .explains = axis_of_touching_cores<BulletAsked::flat>},
    LedgerEntry{
        .id = "bullet-convex2d-near-corner",
        .collider = "bullet-convex2d",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .explains = stopped_at_near_corner<BulletAsked::flat>},
    LedgerEntry{.id = "bullet-convex2d-relative-error",
                .collider = "bullet-convex2d",
                .description = "the query ends where its squared distance, 1e18 at first, falls by "
                               "less than a millionth",
                .source = kRelativeErrorEnds,
                .explains = stopped_by_relative_error<BulletAsked::flat>},
    LedgerEntry{
        .id = "bullet-convex2d-flat-simplex",
        .collider = "bullet-convex2d",
        .description = "the query ends at four corners in a plane, within 0.0001 of a determinant",
        .source = kFlatSimplex,
        .explains = stopped_at_flat_simplex<BulletAsked::flat>},
    LedgerEntry{
        .id = "bullet-convex2d-displaced-point",
        .collider = "bullet-convex2d",
        .description = "the point is that of a query beside it, whose direction is not the normal",
        .source = kDisplacedPoint,
        .explains = point_of_displaced_query<BulletAsked::flat>},
    LedgerEntry{.id = "bullet-convex2d-axis-of-roundings",
                .collider = "bullet-convex2d",
                .description = "the direction between the closest points of cores so near that the "
                               "roundings of these turn it",
                .source = kDetectorAxis,
                .explains = axis_turned_by_roundings<BulletAsked::flat>},
};

}  // namespace manifuzz::ledger_of
