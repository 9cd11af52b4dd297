#pragma once

#include <array>

#include "oracle/bullet/ledger/query_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, what btGjkPairDetector makes of the answer of btMinkowskiPenetrationDepthSolver.
// Budgets (budgets.json) are twice what 300,000 cases against clip64 showed, or 1,000,000 where
// those show more, rounded up.

inline constexpr std::string_view kDisplacedDistance =
    "Bullet 3.24, btMinkowskiPenetrationDepthSolver.cpp, calcPenDepth: "
    "correctedMinNorm = minProj - res.m_depth";
inline constexpr std::string_view kAxisTakenBack =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "d2 > d0 && d2 > d1 && d2 > distance, normalInB = orgNormalInB";

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletDisplaced{
    LedgerEntry{.id = "bullet-minkowski-displaced-distance",
                .collider = "bullet-minkowski",
                .description = "a fixed direction, and the depth that a query beside it leaves, "
                               "both as rounded there",
                .source = kDisplacedDistance,
                .explains = distance_of_displaced_query<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-minkowski-axis-taken-back",
                .collider = "bullet-minkowski",
                .description = "the axis of the query takes the place of the solver's normal, "
                               "since they are less deep along it",
                .source = kAxisTakenBack,
                .explains = axis_taken_back<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-convex2d-displaced-distance",
                .collider = "bullet-convex2d",
                .description = "a fixed direction, and the depth that a query beside it leaves, "
                               "both as rounded there",
                .source = kDisplacedDistance,
                .explains = distance_of_displaced_query<BulletAsked::flat>},
    LedgerEntry{.id = "bullet-convex2d-axis-taken-back",
                .collider = "bullet-convex2d",
                .description = "the axis of the query takes the place of the solver's normal, "
                               "since they are less deep along it",
                .source = kAxisTakenBack,
                .explains = axis_taken_back<BulletAsked::flat>},
};

}  // namespace manifuzz::ledger_of
