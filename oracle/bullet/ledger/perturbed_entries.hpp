#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/bullet/ledger/epa_entries.hpp"
#include "oracle/bullet/ledger/perturbed_deviations.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, in float, btConvexConvexAlgorithm with three turns. Budgets are twice what 300,000
// cases against clip64 showed, or 1,000,000 where those show more, rounded up.

inline constexpr Budget kOfPerturbedReplaced[] = {
    {"boxes", 9200},         {"capsules", 7800},         {"circles", 33000},
    {"cores_touch", 1200},   {"corner_corner", 7400},    {"corner_face", 12000},
    {"deep", 9600},          {"far_from_origin", 27000}, {"generic", 25000},
    {"grid", 6600},          {"in_line", 17000},         {"large_radii", 16000},
    {"micro_edge", 7800},    {"mixed_shapes", 11000},    {"near_collinear", 13000},
    {"near_parallel", 4200}, {"off_unit", 20000},        {"regular", 15000},
    {"round_corners", 8800}, {"scaled", 14000},          {"side_planes", 4800},
    {"sliver", 23000},       {"tie_bias", 20000},        {"tied_faces", 8000},
    {"tilted_edges", 1800},  {"touching", 20000},        {"ulp", 15000},
    {"voronoi_lines", 12000}};
inline constexpr Budget kOfPerturbedRefreshed[] = {
    {"boxes", 19000},        {"capsules", 3600},        {"circles", 1200},
    {"cores_touch", 800},    {"corner_corner", 4800},   {"corner_face", 5000},
    {"deep", 1200},          {"far_from_origin", 8800}, {"generic", 15000},
    {"grid", 23000},         {"in_line", 1000},         {"large_radii", 400},
    {"micro_edge", 3200},    {"mixed_shapes", 3400},    {"near_collinear", 8400},
    {"near_parallel", 9000}, {"off_unit", 6000},        {"regular", 12000},
    {"round_corners", 3400}, {"scaled", 9200},          {"side_planes", 7600},
    {"sliver", 12000},       {"tie_bias", 3400},        {"tied_faces", 3200},
    {"tilted_edges", 2400},  {"touching", 19000},       {"ulp", 7800},
    {"voronoi_lines", 2400}};
inline constexpr Budget kOfPerturbedTurnedNormal[] = {
    {"boxes", 200000},         {"capsules", 420000},        {"circles", 580000},
    {"cores_touch", 290000},   {"corner_corner", 470000},   {"corner_face", 340000},
    {"deep", 500000},          {"far_from_origin", 120000}, {"generic", 150000},
    {"grid", 160000},          {"in_line", 630000},         {"large_radii", 310000},
    {"micro_edge", 580000},    {"mixed_shapes", 470000},    {"near_collinear", 300000},
    {"near_parallel", 330000}, {"off_unit", 280000},        {"regular", 260000},
    {"round_corners", 330000}, {"scaled", 150000},          {"side_planes", 300000},
    {"sliver", 380000},        {"tie_bias", 820000},        {"tied_faces", 440000},
    {"tilted_edges", 220000},  {"touching", 210000},        {"ulp", 340000},
    {"voronoi_lines", 490000}};
inline constexpr Budget kOfPerturbedTurnedPoint[] = {
    {"boxes", 200000},         {"capsules", 590000},       {"circles", 440000},
    {"cores_touch", 320000},   {"corner_corner", 28000},   {"corner_face", 120000},
    {"deep", 58000},           {"far_from_origin", 61000}, {"generic", 140000},
    {"grid", 120000},          {"in_line", 380000},        {"large_radii", 660000},
    {"micro_edge", 48000},     {"mixed_shapes", 530000},   {"near_collinear", 120000},
    {"near_parallel", 78000},  {"off_unit", 130000},       {"regular", 250000},
    {"round_corners", 680000}, {"scaled", 36000},          {"side_planes", 610000},
    {"sliver", 71000},         {"tie_bias", 120000},       {"tied_faces", 98000},
    {"tilted_edges", 560000},  {"touching", 16000},        {"ulp", 110000},
    {"voronoi_lines", 520000}};
inline constexpr Budget kOfPerturbedDirectionOfRoundings[] = {{"boxes", 260000},
                                                              {"capsules", 17000},
                                                              {"cores_touch", 8400},
                                                              {"corner_corner", 150000},
                                                              {"corner_face", 160000},
                                                              {"far_from_origin", 93000},
                                                              {"generic", 250000},
                                                              {"grid", 300000},
                                                              {"in_line", 5400},
                                                              {"large_radii", 9200},
                                                              {"micro_edge", 90000},
                                                              {"mixed_shapes", 20000},
                                                              {"near_collinear", 180000},
                                                              {"near_parallel", 170000},
                                                              {"off_unit", 160000},
                                                              {"regular", 240000},
                                                              {"round_corners", 4200},
                                                              {"scaled", 150000},
                                                              {"side_planes", 6400},
                                                              {"sliver", 250000},
                                                              {"tie_bias", 290000},
                                                              {"tied_faces", 110000},
                                                              {"tilted_edges", 5800},
                                                              {"touching", 800000},
                                                              {"ulp", 210000},
                                                              {"voronoi_lines", 3200}};
inline constexpr Budget kOfPerturbedLeastDistance[] = {
    {"boxes", 44000},          {"capsules", 3600},
    {"corner_corner", 36000},  {"corner_face", 58000},
    {"far_from_origin", 5000}, {"generic", 49000},
    {"large_radii", 400},      {"micro_edge", 70000},
    {"mixed_shapes", 7800},    {"near_collinear", 66000},
    {"near_parallel", 80000},  {"off_unit", 5600},
    {"regular", 49000},        {"round_corners", 2000},
    {"scaled", 42000},         {"side_planes", 2800},
    {"sliver", 93000},         {"tie_bias", 53000},
    {"tied_faces", 53000},     {"tilted_edges", 1000},
    {"touching", 2000},        {"ulp", 38000},
    {"voronoi_lines", 1000}};
inline constexpr Budget kOfPerturbedTouchingAxis[] = {{"capsules", 3100},
                                                      {"cores_touch", 630000},
                                                      {"in_line", 170000},
                                                      {"mixed_shapes", 3000},
                                                      {"round_corners", 4600},
                                                      {"scaled", 8400},
                                                      {"side_planes", 4500},
                                                      {"tie_bias", 250},
                                                      {"tied_faces", 600},
                                                      {"tilted_edges", 2000},
                                                      {"ulp", 850},
                                                      {"voronoi_lines", 2500},
                                                      {"micro_edge", 1700},
                                                      {"near_collinear", 120},
                                                      {"near_parallel", 240},
                                                      {"sliver", 180}};
inline constexpr Budget kOfPerturbedNearCorner[] = {{"large_radii", 1600}, {"micro_edge", 400},
                                                    {"scaled", 15000},     {"side_planes", 400},
                                                    {"tied_faces", 200},   {"ulp", 600}};
inline constexpr Budget kOfPerturbedRelativeError[] = {
    {"capsules", 200},     {"circles", 200},      {"cores_touch", 600},   {"large_radii", 21000},
    {"mixed_shapes", 400}, {"side_planes", 1000}, {"voronoi_lines", 1400}};
inline constexpr Budget kOfPerturbedFlatSimplex[] = {
    {"capsules", 400},     {"cores_touch", 3700},  {"in_line", 2600},     {"large_radii", 1800},
    {"mixed_shapes", 400}, {"round_corners", 400}, {"scaled", 23000},     {"side_planes", 400},
    {"ulp", 1300},         {"circles", 61},        {"tilted_edges", 190}, {"voronoi_lines", 610}};
inline constexpr Budget kOfPerturbedTurnedBack[] = {{"boxes", 1400},
                                                    {"cores_touch", 41000},
                                                    {"corner_corner", 3500},
                                                    {"deep", 2200},
                                                    {"far_from_origin", 400},
                                                    {"generic", 200},
                                                    {"in_line", 16000},
                                                    {"micro_edge", 5700},
                                                    {"off_unit", 1500},
                                                    {"regular", 420},
                                                    {"scaled", 4200},
                                                    {"side_planes", 370},
                                                    {"sliver", 1400},
                                                    {"tie_bias", 13000},
                                                    {"tied_faces", 2400},
                                                    {"tilted_edges", 200},
                                                    {"ulp", 1900},
                                                    {"capsules", 130},
                                                    {"corner_face", 61},
                                                    {"near_collinear", 420},
                                                    {"near_parallel", 660},
                                                    {"round_corners", 61},
                                                    {"voronoi_lines", 61}};
inline constexpr Budget kOfPerturbedAxisOfRoundings[] = {{"capsules", 200},
                                                         {"cores_touch", 3000},
                                                         {"in_line", 1200},
                                                         {"round_corners", 200},
                                                         {"side_planes", 200}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletPerturbed{
    LedgerEntry{.id = "bullet-perturbed-replaced",
                .collider = "bullet-perturbed",
                .description = "a point of the turned shapes takes the place of a right one nearby",
                .source = "Bullet 3.24, btPersistentManifold.cpp, getCacheEntry; "
                          "btManifoldResult.cpp, addContactPoint: replaceContactPoint",
                .budgets = kOfPerturbedReplaced,
                .explains = point_replaced_by_turned},
    LedgerEntry{.id = "bullet-perturbed-refreshed",
                .collider = "bullet-perturbed",
                .description = "a point is measured anew between its places on both shapes, or "
                               "left out since these moved apart",
                .source = "Bullet 3.24, btPersistentManifold.cpp, refreshContactPoints",
                .budgets = kOfPerturbedRefreshed,
                .explains = changed_by_refresh},
    LedgerEntry{.id = "bullet-perturbed-turned-normal",
                .collider = "bullet-perturbed",
                .description = "the deepest point is one of the turned shapes, along their normal",
                .source = "Bullet 3.24, btConvexConvexAlgorithm.cpp, btPerturbedContactResult: "
                          "addContactPoint(normalOnBInWorld, startPt, newDepth)",
                .budgets = kOfPerturbedTurnedNormal,
                .explains = normal_of_turned_query},
    LedgerEntry{.id = "bullet-perturbed-turned-point",
                .collider = "bullet-perturbed",
                .description = "the second point is one of the turned shapes, taken back: beside "
                               "the manifold, short of its end, or measured along their normal",
                .source = "Bullet 3.24, btConvexConvexAlgorithm.cpp, btPerturbedContactResult: "
                          "newDepth = (endPt - startPt).dot(normalOnBInWorld)",
                .budgets = kOfPerturbedTurnedPoint,
                .explains = point_of_turned_query},
    LedgerEntry{
        .id = "bullet-perturbed-direction-of-roundings",
        .collider = "bullet-perturbed",
        .description = "a shallow contact's normal is the direction between two points, "
                       "roundings of which are as long, before shapes are turned",
        .source = kDirectionOfPoints,
        .budgets = kOfPerturbedDirectionOfRoundings,
        .explains = of_first_query<by_query<BulletAsked::epa, direction_of_short_translation>>},
    LedgerEntry{.id = "bullet-perturbed-least-distance",
                .collider = "bullet-perturbed",
                .description = "overlap, gap and touch within 0.0001 are not told apart, before "
                               "shapes are turned",
                .source = "Bullet 3.24, btGjkEpa2.cpp, GJK::Evaluate: rl < GJK_MIN_DISTANCE is "
                          "Inside",
                .budgets = kOfPerturbedLeastDistance,
                .explains = of_first_query<epa_below_least_distance>},
    LedgerEntry{.id = "bullet-perturbed-touching-axis",
                .collider = "bullet-perturbed",
                .description =
                    "cores within 0.001 of touching: the loop ends before it renews the "
                    "distance, so the normal is that of two points that nearly coincide, and "
                    "the point is moved to the surface by the step before's distance",
                .source = kDetectorKeepsAxis,
                .budgets = kOfPerturbedTouchingAxis,
                .explains = of_first_query<axis_of_touching_cores<BulletAsked::epa>>},
    LedgerEntry{
        .id = "bullet-perturbed-near-corner",
        .collider = "bullet-perturbed",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .budgets = kOfPerturbedNearCorner,
        .explains = of_first_query<stopped_at_near_corner<BulletAsked::epa>>},
    LedgerEntry{.id = "bullet-perturbed-relative-error",
                .collider = "bullet-perturbed",
                .description = "the query ends where its squared distance, 1e18 at first, falls by "
                               "less than a millionth",
                .source = kRelativeErrorEnds,
                .budgets = kOfPerturbedRelativeError,
                .explains = of_first_query<stopped_by_relative_error<BulletAsked::epa>>},
    LedgerEntry{
        .id = "bullet-perturbed-flat-simplex",
        .collider = "bullet-perturbed",
        .description = "the query ends at four corners in a plane, within 0.0001 of a determinant",
        .source = kFlatSimplex,
        .budgets = kOfPerturbedFlatSimplex,
        .explains = of_first_query<stopped_at_flat_simplex<BulletAsked::epa>>},
    LedgerEntry{
        .id = "bullet-perturbed-turned-back",
        .collider = "bullet-perturbed",
        .description = "the normal is reversed by what compares distances along both directions",
        .source = kTurnedBack,
        .budgets = kOfPerturbedTurnedBack,
        .explains = of_first_query<normal_turned_back<BulletAsked::epa>>},
    LedgerEntry{.id = "bullet-perturbed-axis-of-roundings",
                .collider = "bullet-perturbed",
                .description = "the direction between the closest points of cores so near that the "
                               "roundings of these turn it",
                .source = kDetectorAxis,
                .budgets = kOfPerturbedAxisOfRoundings,
                .explains = of_first_query<axis_turned_by_roundings<BulletAsked::epa>>},
};

}  // namespace manifuzz::ledger_of
