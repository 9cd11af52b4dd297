#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/bullet/ledger/query_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, in float. Budgets (budgets.json) are twice what 1,000,000 cases against clip64
// showed, rounded up.

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

/// The entries, the first that explains before others.
inline constexpr std::array kOfBullet{
    LedgerEntry{.id = "bullet-epa-direction-of-roundings",
                .collider = "bullet-epa",
                .description = "a shallow contact's normal is the direction between two points, "
                               "roundings of which are as long",
                .source = kDirectionOfPoints,
                .explains = by_query<BulletAsked::epa, direction_of_short_translation>},
    LedgerEntry{.id = "bullet-epa-least-distance",
                .collider = "bullet-epa",
                .description = "overlap, gap and touch within 0.0001 are not told apart",
                .source = "Bullet 3.24, btGjkEpa2.cpp, GJK::Evaluate: rl < GJK_MIN_DISTANCE is "
                          "Inside",
                .explains = epa_below_least_distance},
    LedgerEntry{.id = "bullet-minkowski-fixed-directions",
                .collider = "bullet-minkowski",
                .description = "the normal is one of ten in the plane, 36 degrees apart, and the "
                               "depth that of a query beside it",
                .source = kFixedDirections,
                .explains = by_query<BulletAsked::directions, least_of_fixed_directions>,
                .is_no_bug = true},
    LedgerEntry{.id = "bullet-minkowski-direction-of-roundings",
                .collider = "bullet-minkowski",
                .description = "a shallow contact's normal is the direction between two points, "
                               "roundings of which are as long",
                .source = kDirectionOfPoints,
                .explains = by_query<BulletAsked::directions, direction_of_short_translation>},
    LedgerEntry{.id = "bullet-minkowski-gap-as-depth",
                .collider = "bullet-minkowski",
                .description = "contact for shapes apart, the gap's width as the depth",
                .source = kSignOfDistance,
                .explains = by_solver<BulletAsked::directions, gap_as_depth>},
    LedgerEntry{
        .id = "bullet-minkowski-equal-vertices",
        .collider = "bullet-minkowski",
        .description = "contact for shapes apart, a depth smaller than the gap's width: corners "
                       "nearer than 0.01 are one",
        .source = kEqualVertices,
        .explains = by_query<BulletAsked::directions, least_of_fixed_directions_of_equal_vertices>},
    LedgerEntry{.id = "bullet-convex2d-flattened-directions",
                .collider = "bullet-convex2d",
                .description = "a direction that is shorter than 1 without its z is taken to have "
                               "the least depth, and the displaced shapes may still overlap",
                .source = "Bullet 3.24, btMinkowskiPenetrationDepthSolver.cpp, calcPenDepth: "
                          "norm[2] = 0.f where check2d",
                .explains = by_query<BulletAsked::flat, least_of_flattened_directions>},
    LedgerEntry{.id = "bullet-convex2d-direction-of-roundings",
                .collider = "bullet-convex2d",
                .description = "a shallow contact's normal is the direction between two points, "
                               "roundings of which are as long",
                .source = kDirectionOfPoints,
                .explains = by_query<BulletAsked::flat, direction_of_short_translation>},
    LedgerEntry{.id = "bullet-convex2d-gap-as-depth",
                .collider = "bullet-convex2d",
                .description = "contact for shapes apart, the gap's width as the depth",
                .source = kSignOfDistance,
                .explains = by_solver<BulletAsked::flat, gap_as_depth>},
    LedgerEntry{
        .id = "bullet-convex2d-equal-vertices",
        .collider = "bullet-convex2d",
        .description = "contact for shapes apart, a depth smaller than the gap's width: corners "
                       "nearer than 0.01 are one",
        .source = kEqualVertices,
        .explains = by_query<BulletAsked::flat, least_of_flattened_directions_of_equal_vertices>},
};

}  // namespace manifuzz::ledger_of
