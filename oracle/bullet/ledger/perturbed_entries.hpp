#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/bullet/ledger/epa_entries.hpp"
#include "oracle/bullet/ledger/perturbed_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, in float, btConvexConvexAlgorithm with three turns. Budgets (budgets.json) are twice
// what 300,000 cases against clip64 showed, or 1,000,000 where those show more, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletPerturbed{
    LedgerEntry{.id = "bullet-perturbed-replaced",
                .collider = "bullet-perturbed",
                .description = "a point of the turned shapes takes the place of a right one nearby",
                .source = "Bullet 3.24, btPersistentManifold.cpp, getCacheEntry; "
                          "btManifoldResult.cpp, addContactPoint: replaceContactPoint",
                .explains = point_replaced_by_turned},
    LedgerEntry{.id = "bullet-perturbed-refreshed",
                .collider = "bullet-perturbed",
                .description = "a point is measured anew between its places on both shapes, or "
                               "left out since these moved apart",
                .source = "Bullet 3.24, btPersistentManifold.cpp, refreshContactPoints",
                .explains = changed_by_refresh},
    LedgerEntry{.id = "bullet-perturbed-turned-normal",
                .collider = "bullet-perturbed",
                .description = "the deepest point is one of the turned shapes, along their normal",
                .source = "Bullet 3.24, btConvexConvexAlgorithm.cpp, btPerturbedContactResult: "
                          "addContactPoint(normalOnBInWorld, startPt, newDepth)",
                .explains = normal_of_turned_query},
    LedgerEntry{.id = "bullet-perturbed-turned-point",
                .collider = "bullet-perturbed",
                .description = "the second point is one of the turned shapes, taken back: beside "
                               "the manifold, short of its end, or measured along their normal",
                .source = "Bullet 3.24, btConvexConvexAlgorithm.cpp, btPerturbedContactResult: "
                          "newDepth = (endPt - startPt).dot(normalOnBInWorld)",
                .explains = point_of_turned_query},
    LedgerEntry{
        .id = "bullet-perturbed-direction-of-roundings",
        .collider = "bullet-perturbed",
        .description = "a shallow contact's normal is the direction between two points, "
                       "roundings of which are as long, before shapes are turned",
        .source = kDirectionOfPoints,
        .explains = of_first_query<by_query<BulletAsked::epa, direction_of_short_translation>>},
    LedgerEntry{.id = "bullet-perturbed-least-distance",
                .collider = "bullet-perturbed",
                .description = "overlap, gap and touch within 0.0001 are not told apart, before "
                               "shapes are turned",
                .source = "Bullet 3.24, btGjkEpa2.cpp, GJK::Evaluate: rl < GJK_MIN_DISTANCE is "
                          "Inside",
                .explains = of_first_query<epa_below_least_distance>},
    LedgerEntry{.id = "bullet-perturbed-touching-axis",
                .collider = "bullet-perturbed",
                .description =
                    "cores within 0.001 of touching: the loop ends before it renews the "
                    "distance, so the normal is that of two points that nearly coincide, and "
                    "the point is moved to the surface by the step before's distance",
                .source = kDetectorKeepsAxis,
                .explains = of_first_query<axis_of_touching_cores<BulletAsked::epa>>},
    LedgerEntry{
        .id = "bullet-perturbed-near-corner",
        .collider = "bullet-perturbed",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .explains = of_first_query<stopped_at_near_corner<BulletAsked::epa>>},
    LedgerEntry{.id = "bullet-perturbed-relative-error",
                .collider = "bullet-perturbed",
                .description = "the query ends where its squared distance, 1e18 at first, falls by "
                               "less than a millionth",
                .source = kRelativeErrorEnds,
                .explains = of_first_query<stopped_by_relative_error<BulletAsked::epa>>},
    LedgerEntry{
        .id = "bullet-perturbed-flat-simplex",
        .collider = "bullet-perturbed",
        .description = "the query ends at four corners in a plane, within 0.0001 of a determinant",
        .source = kFlatSimplex,
        .explains = of_first_query<stopped_at_flat_simplex<BulletAsked::epa>>},
    LedgerEntry{
        .id = "bullet-perturbed-turned-back",
        .collider = "bullet-perturbed",
        .description = "the normal is reversed by what compares distances along both directions",
        .source = kTurnedBack,
        .explains = of_first_query<normal_turned_back<BulletAsked::epa>>},
    LedgerEntry{.id = "bullet-perturbed-axis-of-roundings",
                .collider = "bullet-perturbed",
                .description = "the direction between the closest points of cores so near that the "
                               "roundings of these turn it",
                .source = kDetectorAxis,
                .explains = of_first_query<axis_turned_by_roundings<BulletAsked::epa>>},
};

}  // namespace manifuzz::ledger_of
