#pragma once

#include <array>

#include "judging/ledger/gjk_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, in float.

/// The entries, the first that explains before others.
inline constexpr std::array kOfBullet{
    LedgerEntry{.id = "bullet-epa-gap-as-depth",
                .collider = "bullet-epa",
                .description = "contact for shapes apart by less than 0.0001, the gap's width as "
                               "the depth",
                .source = "Bullet 3.24, btGjkEpa2.cpp, GJK::Evaluate: rl < GJK_MIN_DISTANCE is "
                          "Inside; btGjkPairDetector.cpp: distance2 = -length",
                .budgets = {},
                .explains = gap_below_gjk_distance},
    LedgerEntry{.id = "bullet-epa-direction-of-roundings",
                .collider = "bullet-epa",
                .description = "a shallow contact's normal is that of the roundings between its "
                               "two closest points",
                .source = "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
                          "tmpNormalInB = tmpPointOnB - tmpPointOnA",
                .budgets = {},
                .explains = direction_of_short_translation},
    LedgerEntry{.id = "bullet-minkowski-fixed-directions",
                .collider = "bullet-minkowski",
                .description = "the normal is one of ten in the plane, 36 degrees apart, and the "
                               "depth that of a query beside it",
                .source = "Bullet 3.24, btMinkowskiPenetrationDepthSolver.cpp, calcPenDepth: "
                          "`just take fixed number of orientation`",
                .budgets = {},
                .explains = least_of_fixed_directions},
    LedgerEntry{.id = "bullet-convex2d-flattened-directions",
                .collider = "bullet-convex2d",
                .description = "a direction that is shorter than 1 without its z is taken to have "
                               "the least depth, and the displaced shapes may still overlap",
                .source = "Bullet 3.24, btMinkowskiPenetrationDepthSolver.cpp, calcPenDepth: "
                          "norm[2] = 0.f where check2d",
                .budgets = {},
                .explains = least_of_flattened_directions},
};

}  // namespace manifuzz::ledger_of
