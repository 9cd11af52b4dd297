#pragma once

#include <array>

#include "oracle/bullet/ledger/query_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, what btGjkPairDetector makes of the answer of btMinkowskiPenetrationDepthSolver.
// Budgets are twice what 300,000 cases against clip64 showed, or 1,000,000 where those show more,
// rounded up.

inline constexpr std::string_view kDisplacedDistance =
    "Bullet 3.24, btMinkowskiPenetrationDepthSolver.cpp, calcPenDepth: "
    "correctedMinNorm = minProj - res.m_depth";
inline constexpr std::string_view kAxisTakenBack =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "d2 > d0 && d2 > d1 && d2 > distance, normalInB = orgNormalInB";

inline constexpr Budget kOfBulletMinkowskiDisplacedDistance[] = {
    {"far_from_origin", 200}, {"micro_edge", 360},  {"near_collinear", 1000},
    {"scaled", 1700},         {"side_planes", 200}, {"sliver", 1200},
    {"tie_bias", 400},        {"ulp", 430},         {"corner_face", 61},
    {"near_parallel", 420},   {"off_unit", 130},    {"tied_faces", 120}};
inline constexpr Budget kOfBulletMinkowskiAxisTakenBack[] = {
    {"near_collinear", 200}, {"off_unit", 200},    {"scaled", 7000},    {"tie_bias", 1400},
    {"tied_faces", 540},     {"touching", 400},    {"ulp", 430},        {"cores_touch", 130},
    {"corner_corner", 540},  {"corner_face", 430}, {"micro_edge", 480}, {"near_parallel", 60},
    {"round_corners", 61}};
inline constexpr Budget kOfBulletConvex2dDisplacedDistance[] = {
    {"boxes", 300},         {"corner_face", 430}, {"deep", 8300},          {"generic", 800},
    {"near_parallel", 200}, {"regular", 360},     {"scaled", 22000},       {"sliver", 780},
    {"tied_faces", 1200},   {"ulp", 2300},        {"capsules", 61},        {"cores_touch", 250},
    {"grid", 120},          {"micro_edge", 180},  {"near_collinear", 420}, {"tie_bias", 130}};
inline constexpr Budget kOfBulletConvex2dAxisTakenBack[] = {
    {"scaled", 2200}, {"tie_bias", 200}, {"tied_faces", 200}, {"ulp", 400}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletDisplaced{
    LedgerEntry{.id = "bullet-minkowski-displaced-distance",
                .collider = "bullet-minkowski",
                .description = "a fixed direction, and the depth that a query beside it leaves, "
                               "both as rounded there",
                .source = kDisplacedDistance,
                .budgets = kOfBulletMinkowskiDisplacedDistance,
                .explains = distance_of_displaced_query<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-minkowski-axis-taken-back",
                .collider = "bullet-minkowski",
                .description = "the axis of the query takes the place of the solver's normal, "
                               "since they are less deep along it",
                .source = kAxisTakenBack,
                .budgets = kOfBulletMinkowskiAxisTakenBack,
                .explains = axis_taken_back<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-convex2d-displaced-distance",
                .collider = "bullet-convex2d",
                .description = "a fixed direction, and the depth that a query beside it leaves, "
                               "both as rounded there",
                .source = kDisplacedDistance,
                .budgets = kOfBulletConvex2dDisplacedDistance,
                .explains = distance_of_displaced_query<BulletAsked::flat>},
    LedgerEntry{.id = "bullet-convex2d-axis-taken-back",
                .collider = "bullet-convex2d",
                .description = "the axis of the query takes the place of the solver's normal, "
                               "since they are less deep along it",
                .source = kAxisTakenBack,
                .budgets = kOfBulletConvex2dAxisTakenBack,
                .explains = axis_taken_back<BulletAsked::flat>},
};

}  // namespace manifuzz::ledger_of
