#pragma once

#include <array>

#include "judging/ledger/bullet/perturbed_deviations.hpp"
#include "judging/ledger/bullet/query_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, what its query loses by roundings alone, however it is asked. Budgets are twice what
// 300,000 cases against clip64 showed, rounded up.

inline constexpr std::string_view kRoundedPoint =
    "Bullet 3.24, btVoronoiSimplexSolver.cpp, closestPtPointTriangle: vc = d1 * d4 - d3 * d2; "
    "btGjkPairDetector.cpp, getClosestPointsNonVirtual: inSimplex(w), checkSimplex = true";
inline constexpr std::string_view kRoundedPointInWords =
    "the query ends at a corner that it has and that is nearer than its closest point, which "
    "roundings chose";

inline constexpr Budget kOfBulletEpaRoundedPoint[] = {{"cores_touch", 400}};
inline constexpr Budget kOfBulletMinkowskiRoundedPoint[] = {{"cores_touch", 400}};
inline constexpr Budget kOfBulletConvex2dRoundedPoint[] = {
    {"in_line", 400}, {"scaled", 2200}, {"ulp", 200}};
inline constexpr Budget kOfPerturbedRoundedPoint[] = {{"cores_touch", 400}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletRounded{
    LedgerEntry{.id = "bullet-epa-rounded-point",
                .collider = "bullet-epa",
                .description = kRoundedPointInWords,
                .source = kRoundedPoint,
                .budgets = kOfBulletEpaRoundedPoint,
                .explains = stopped_at_rounded_point<BulletAsked::epa>},
    LedgerEntry{.id = "bullet-minkowski-rounded-point",
                .collider = "bullet-minkowski",
                .description = kRoundedPointInWords,
                .source = kRoundedPoint,
                .budgets = kOfBulletMinkowskiRoundedPoint,
                .explains = stopped_at_rounded_point<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-convex2d-rounded-point",
                .collider = "bullet-convex2d",
                .description = kRoundedPointInWords,
                .source = kRoundedPoint,
                .budgets = kOfBulletConvex2dRoundedPoint,
                .explains = stopped_at_rounded_point<BulletAsked::flat>},
    LedgerEntry{.id = "bullet-perturbed-rounded-point",
                .collider = "bullet-perturbed",
                .description = kRoundedPointInWords,
                .source = kRoundedPoint,
                .budgets = kOfPerturbedRoundedPoint,
                .explains = of_first_query<stopped_at_rounded_point<BulletAsked::epa>>},
};

}  // namespace manifuzz::ledger_of
