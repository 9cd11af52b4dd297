#pragma once

#include <array>

#include "oracle/bullet/ledger/perturbed_deviations.hpp"
#include "oracle/bullet/ledger/query_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, what its query loses by roundings and overflow, however it is asked. Budgets
// (budgets.json) are twice what 300,000 cases against clip64 showed, or 1,000,000 where those show
// more, rounded up.

inline constexpr std::string_view kRoundedPoint =
    "Bullet 3.24, btVoronoiSimplexSolver.cpp, closestPtPointTriangle: vc = d1 * d4 - d3 * d2; "
    "btGjkPairDetector.cpp, getClosestPointsNonVirtual: inSimplex(w), checkSimplex = true";
inline constexpr std::string_view kRoundedPointInWords =
    "the query ends at a corner that it has and that is nearer than its closest point, which "
    "roundings chose";

inline constexpr std::string_view kBetweenPlaces =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: tmpNormalInB = tmpPointOnB - "
    "tmpPointOnA, after positionOffset";
inline constexpr std::string_view kBetweenPlacesInWords =
    "the normal is the direction between two places, which are rounded, and not that of EPA's face";
inline constexpr std::string_view kWithoutAxis =
    "Bullet 3.24, btGjkEpa2.cpp, projectorigin of four, below 0: GJK::Evaluate ends as Valid; "
    "Distance: results.normal of places that are one";
inline constexpr std::string_view kWithoutAxisInWords =
    "no contact: the second GJK finds them apart, at two places that are one";

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletRounded{
    LedgerEntry{.id = "bullet-epa-rounded-point",
                .collider = "bullet-epa",
                .description = kRoundedPointInWords,
                .source = kRoundedPoint,
                .explains = stopped_at_rounded_point<BulletAsked::epa>},
    LedgerEntry{.id = "bullet-minkowski-rounded-point",
                .collider = "bullet-minkowski",
                .description = kRoundedPointInWords,
                .source = kRoundedPoint,
                .explains = stopped_at_rounded_point<BulletAsked::directions>},
    LedgerEntry{.id = "bullet-convex2d-rounded-point",
                .collider = "bullet-convex2d",
                .description = kRoundedPointInWords,
                .source = kRoundedPoint,
                .explains = stopped_at_rounded_point<BulletAsked::flat>},
    LedgerEntry{.id = "bullet-perturbed-rounded-point",
                .collider = "bullet-perturbed",
                .description = kRoundedPointInWords,
                .source = kRoundedPoint,
                .explains = of_first_query<stopped_at_rounded_point<BulletAsked::epa>>},
    LedgerEntry{.id = "bullet-epa-between-places",
                .collider = "bullet-epa",
                .description = kBetweenPlacesInWords,
                .source = kBetweenPlaces,
                .explains = epa_normal_between_places},
    LedgerEntry{.id = "bullet-perturbed-between-places",
                .collider = "bullet-perturbed",
                .description = kBetweenPlacesInWords,
                .source = kBetweenPlaces,
                .explains = of_first_query<epa_normal_between_places>},
    LedgerEntry{.id = "bullet-epa-without-axis",
                .collider = "bullet-epa",
                .description = kWithoutAxisInWords,
                .source = kWithoutAxis,
                .explains = epa_without_axis},
    LedgerEntry{.id = "bullet-perturbed-without-axis",
                .collider = "bullet-perturbed",
                .description = kWithoutAxisInWords,
                .source = kWithoutAxis,
                .explains = of_first_query<epa_without_axis>},
    LedgerEntry{.id = "bullet-perturbed-out-of-plane",
                .collider = "bullet-perturbed",
                .description = "the first query's normal is upright, by its roundings, and the "
                               "shapes are turned out of the plane",
                .source = "Bullet 3.24, btConvexConvexAlgorithm.cpp, processCollision: "
                          "btPlaneSpace1 of getCachedSeparatingAxis",
                .explains = turned_out_of_plane},
    LedgerEntry{.id = "bullet-convex2d-corner-before-first",
                .collider = "bullet-convex2d",
                .description = "squares overflow, and along what is no number a corner is read "
                               "from memory before the first one",
                .source = "Bullet 3.24, btConvexHullShape.cpp, "
                          "localGetSupportingVertexWithoutMargin: index is -1",
                .explains = corner_before_first},
};

}  // namespace manifuzz::ledger_of
