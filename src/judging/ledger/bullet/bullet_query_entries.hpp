#pragma once

#include <array>

#include "judging/ledger/bullet/query_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, its query repeated in float. Budgets are twice what 300,000 cases against clip64
// showed, rounded up.

inline constexpr std::string_view kDetectorKeepsAxis =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "newCachedSeparatingAxis.length2() < REL_ERROR2, then distance2 < distance, or d2 > distance";
inline constexpr std::string_view kNearCorner =
    "Bullet 3.24, btVoronoiSimplexSolver.cpp, inSimplex: distance2(w) <= "
    "m_equalVertexThreshold, 0.0001";
inline constexpr std::string_view kRelativeErrorEnds =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: f0 <= f1, f1 = "
    "squaredDistance * REL_ERROR2; or previousSquaredDistance - squaredDistance <= SIMD_EPSILON";
inline constexpr std::string_view kFlatSimplex =
    "Bullet 3.24, btVoronoiSimplexSolver.cpp, pointOutsideOfPlane: signd * signd < "
    "(1e-4) * (1e-4); updateClosestVectorAndPoints: isValid";
inline constexpr std::string_view kGjkApart =
    "Bullet 3.24, btGjkEpa2.cpp, GJK::Evaluate: length2() < GJK_DUPLICATED_EPS "
    "ends it; btGjkPairDetector.cpp: distance2 of the second GJK";
inline constexpr std::string_view kFallBack =
    "Bullet 3.24, btGjkEpa2.cpp, EPA::Evaluate: eStatus::FallBack, "
    "m_normal = -guess";
inline constexpr std::string_view kDisplacedPoint =
    "Bullet 3.24, btMinkowskiPenetrationDepthSolver.cpp, calcPenDepth: "
    "pb = res.m_pointInWorld, v = minNorm";
inline constexpr std::string_view kDetectorAxis =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "normalInB = m_cachedSeparatingAxis";
inline constexpr std::string_view kTurnedBack =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: d1 > d0, "
    "normalInB *= -1";
inline constexpr std::string_view kInvalidHull =
    "Bullet 3.24, btGjkEpa2.cpp, EPA::Evaluate: eStatus::InvalidHull, which "
    "Penetration takes as any but Failed";
inline constexpr std::string_view kBesideFace =
    "Bullet 3.24, btGjkEpa2.cpp, EPA::newface: getedgedist is d; EPA::Evaluate: "
    "projection = outer.n * outer.d";
inline constexpr std::string_view kChord =
    "Bullet 3.24, btGjkEpa2.cpp, EPA::Evaluate: wdist > EPA_ACCURACY, and the face "
    "decides";

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletQuery{
    LedgerEntry{.id = "bullet-epa-touching-axis",
                .collider = "bullet-epa",
                .description = "cores within 0.001 of touching: the normal is the direction "
                               "between two points of them, which roundings may make",
                .source = kDetectorKeepsAxis,
                .explains = axis_of_touching_cores<BulletAsked::epa>},
    LedgerEntry{
        .id = "bullet-epa-near-corner",
        .collider = "bullet-epa",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .explains = stopped_at_near_corner<BulletAsked::epa>},
    LedgerEntry{
        .id = "bullet-epa-relative-error",
        .collider = "bullet-epa",
        .description = "the query ends where its squared distance falls by less than a millionth",
        .source = kRelativeErrorEnds,
        .explains = stopped_by_relative_error<BulletAsked::epa>},
    LedgerEntry{
        .id = "bullet-epa-flat-simplex",
        .collider = "bullet-epa",
        .description = "the query ends at four corners in a plane, within 0.0001 of a determinant",
        .source = kFlatSimplex,
        .explains = stopped_at_flat_simplex<BulletAsked::epa>},
    LedgerEntry{
        .id = "bullet-epa-turned-back",
        .collider = "bullet-epa",
        .description = "the normal is reversed by what compares distances along both directions",
        .source = kTurnedBack,
        .explains = normal_turned_back<BulletAsked::epa>},
    LedgerEntry{.id = "bullet-epa-gjk-apart",
                .collider = "bullet-epa",
                .description =
                    "the GJK of the EPA finds them apart, ended by a corner within 0.01 of another",
                .source = kGjkApart,
                .explains = epa_finds_apart},
    LedgerEntry{
        .id = "bullet-epa-fall-back",
        .collider = "bullet-epa",
        .description = "EPA finds no tetrahedron about the origin: its guess, and a depth of 0",
        .source = kFallBack,
        .explains = epa_falls_back},
    LedgerEntry{
        .id = "bullet-epa-invalid-hull",
        .collider = "bullet-epa",
        .description = "EPA ends at a hull that it cannot expand, with the face that it had",
        .source = kInvalidHull,
        .explains = epa_at_invalid_hull},
    LedgerEntry{
        .id = "bullet-epa-beside-face",
        .collider = "bullet-epa",
        .description = "the depth of a face's edge along the face's normal, the point off the face",
        .source = kBesideFace,
        .explains = epa_beside_face},
    LedgerEntry{.id = "bullet-epa-chord",
                .collider = "bullet-epa",
                .description = "a face within 0.0001 of a curved shape, and not tangent to it",
                .source = kChord,
                .explains = epa_at_chord},
    LedgerEntry{.id = "bullet-epa-axis-of-roundings",
                .collider = "bullet-epa",
                .description = "the direction between the closest points of cores so near that the "
                               "roundings of these turn it",
                .source = kDetectorAxis,
                .explains = axis_turned_by_roundings<BulletAsked::epa>},
    LedgerEntry{.id = "bullet-minkowski-touching-axis",
                .collider = "bullet-minkowski",
                .description = "cores within 0.001 of touching: the normal is the direction "
                               "between two points of them, which roundings may make",
                .source = kDetectorKeepsAxis,
                .explains = axis_of_touching_cores<BulletAsked::directions>},
    LedgerEntry{
        .id = "bullet-minkowski-near-corner",
        .collider = "bullet-minkowski",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .explains = stopped_at_near_corner<BulletAsked::directions>},
    LedgerEntry{
        .id = "bullet-minkowski-relative-error",
        .collider = "bullet-minkowski",
        .description = "the query ends where its squared distance falls by less than a millionth",
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
                .description = "cores within 0.001 of touching: the normal is the direction "
                               "between two points of them, which roundings may make",
                .source = kDetectorKeepsAxis,
                .explains = axis_of_touching_cores<BulletAsked::flat>},
    LedgerEntry{
        .id = "bullet-convex2d-near-corner",
        .collider = "bullet-convex2d",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .explains = stopped_at_near_corner<BulletAsked::flat>},
    LedgerEntry{
        .id = "bullet-convex2d-relative-error",
        .collider = "bullet-convex2d",
        .description = "the query ends where its squared distance falls by less than a millionth",
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
