#pragma once

#include <array>

#include "oracle/bullet/ledger/perturbed_deviations.hpp"
#include "oracle/bullet/ledger/query_entries.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, its query repeated in float. Budgets are twice what 300,000 cases against clip64
// showed, or 1,000,000 where those show more, rounded up.

inline constexpr std::string_view kGjkApart =
    "Bullet 3.24, btGjkEpa2.cpp, GJK::Evaluate: length2() < GJK_DUPLICATED_EPS "
    "ends it; btGjkPairDetector.cpp: distance2 of the second GJK";
inline constexpr std::string_view kFallBack =
    "Bullet 3.24, btGjkEpa2.cpp, EPA::Evaluate: eStatus::FallBack, "
    "m_normal = -guess";
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

inline constexpr Budget kOfBulletEpaTouchingAxis[] = {
    {"capsules", 3100},     {"cores_touch", 610000}, {"in_line", 160000},  {"micro_edge", 1800},
    {"mixed_shapes", 3000}, {"round_corners", 5000}, {"scaled", 8800},     {"side_planes", 4700},
    {"sliver", 540},        {"tie_bias", 370},       {"tied_faces", 1600}, {"tilted_edges", 2200},
    {"ulp", 1300},          {"voronoi_lines", 2500}, {"corner_face", 61},  {"near_collinear", 180},
    {"near_parallel", 600}, {"off_unit", 61}};
inline constexpr Budget kOfBulletEpaNearCorner[] = {{"large_radii", 1600}, {"micro_edge", 400},
                                                    {"scaled", 15000},     {"side_planes", 400},
                                                    {"tied_faces", 200},   {"ulp", 600}};
inline constexpr Budget kOfBulletEpaRelativeError[] = {
    {"capsules", 200},     {"circles", 200},      {"cores_touch", 600},   {"large_radii", 22000},
    {"mixed_shapes", 400}, {"side_planes", 1000}, {"voronoi_lines", 1400}};
inline constexpr Budget kOfBulletEpaFlatSimplex[] = {
    {"capsules", 400},     {"cores_touch", 3700},  {"in_line", 2600},     {"large_radii", 1900},
    {"mixed_shapes", 400}, {"round_corners", 400}, {"scaled", 26000},     {"side_planes", 400},
    {"ulp", 1300},         {"circles", 61},        {"tilted_edges", 190}, {"voronoi_lines", 610}};
inline constexpr Budget kOfBulletEpaTurnedBack[] = {{"boxes", 1600},
                                                    {"cores_touch", 41000},
                                                    {"corner_corner", 4800},
                                                    {"deep", 400},
                                                    {"far_from_origin", 490},
                                                    {"generic", 200},
                                                    {"in_line", 16000},
                                                    {"micro_edge", 6400},
                                                    {"off_unit", 1700},
                                                    {"regular", 600},
                                                    {"scaled", 4000},
                                                    {"side_planes", 370},
                                                    {"sliver", 2300},
                                                    {"tie_bias", 17000},
                                                    {"tied_faces", 4400},
                                                    {"tilted_edges", 200},
                                                    {"ulp", 2600},
                                                    {"capsules", 190},
                                                    {"corner_face", 61},
                                                    {"near_collinear", 960},
                                                    {"near_parallel", 840},
                                                    {"round_corners", 61},
                                                    {"voronoi_lines", 61}};
inline constexpr Budget kOfBulletEpaGjkApart[] = {
    {"cores_touch", 200},   {"corner_corner", 200},  {"in_line", 310},
    {"micro_edge", 2700},   {"near_collinear", 360}, {"off_unit", 200},
    {"scaled", 1800},       {"tied_faces", 1700},    {"ulp", 310},
    {"voronoi_lines", 200}, {"boxes", 60},           {"capsules", 190},
    {"corner_face", 61},    {"generic", 120},        {"mixed_shapes", 61},
    {"near_parallel", 300}, {"round_corners", 61},   {"side_planes", 130},
    {"sliver", 1500},       {"tie_bias", 730},       {"tilted_edges", 190}};
inline constexpr Budget kOfBulletEpaFallBack[] = {
    {"micro_edge", 840},    {"near_collinear", 3200}, {"near_parallel", 1100},
    {"scaled", 2000},       {"tilted_edges", 200},    {"ulp", 430},
    {"capsules", 61},       {"corner_corner", 60},    {"mixed_shapes", 730},
    {"round_corners", 190}, {"side_planes", 61},      {"touching", 61}};
inline constexpr Budget kOfBulletEpaInvalidHull[] = {
    {"boxes", 200},           {"capsules", 3400},     {"cores_touch", 410000},
    {"corner_corner", 2000},  {"deep", 1000},         {"grid", 600},
    {"in_line", 1200},        {"micro_edge", 4800},   {"mixed_shapes", 4400},
    {"near_collinear", 2000}, {"near_parallel", 200}, {"regular", 200},
    {"round_corners", 14000}, {"scaled", 7600},       {"side_planes", 1600},
    {"sliver", 1000},         {"tie_bias", 6000},     {"tied_faces", 3600},
    {"tilted_edges", 600},    {"ulp", 2000},          {"voronoi_lines", 5200}};
inline constexpr Budget kOfBulletEpaBesideFace[] = {{"cores_touch", 200},   {"corner_corner", 5300},
                                                    {"in_line", 310},       {"micro_edge", 4100},
                                                    {"mixed_shapes", 200},  {"near_collinear", 720},
                                                    {"near_parallel", 200}, {"regular", 400},
                                                    {"sliver", 1100},       {"tie_bias", 6700},
                                                    {"tied_faces", 3500},   {"touching", 2600},
                                                    {"ulp", 1400},          {"grid", 60},
                                                    {"off_unit", 61},       {"scaled", 130}};
inline constexpr Budget kOfBulletEpaChord[] = {{"capsules", 20000},      {"cores_touch", 230000},
                                               {"in_line", 150000},      {"mixed_shapes", 15000},
                                               {"round_corners", 27000}, {"side_planes", 2600},
                                               {"tilted_edges", 15000},  {"voronoi_lines", 8400}};
inline constexpr Budget kOfBulletEpaAxisOfRoundings[] = {{"capsules", 200},
                                                         {"cores_touch", 3000},
                                                         {"in_line", 1200},
                                                         {"round_corners", 200},
                                                         {"side_planes", 200}};

inline constexpr Budget kOfBulletEpaInnerFace[] = {
    {"near_collinear", 600}, {"near_parallel", 900}, {"sliver", 11000}, {"tied_faces", 540},
    {"micro_edge", 120},     {"tie_bias", 61},       {"ulp", 610}};
inline constexpr Budget kOfPerturbedGjkApart[] = {
    {"cores_touch", 200},    {"corner_corner", 200}, {"in_line", 310},       {"micro_edge", 2500},
    {"scaled", 1700},        {"ulp", 200},           {"voronoi_lines", 200}, {"boxes", 60},
    {"capsules", 190},       {"corner_face", 61},    {"generic", 120},       {"mixed_shapes", 61},
    {"near_collinear", 120}, {"near_parallel", 60},  {"round_corners", 61},  {"side_planes", 130},
    {"sliver", 1100},        {"tie_bias", 370},      {"tied_faces", 360},    {"tilted_edges", 190}};
inline constexpr Budget kOfPerturbedFallBack[] = {
    {"micro_edge", 780},    {"near_collinear", 3200}, {"near_parallel", 840},
    {"scaled", 1800},       {"tilted_edges", 200},    {"ulp", 370},
    {"capsules", 61},       {"corner_corner", 60},    {"mixed_shapes", 730},
    {"round_corners", 190}, {"side_planes", 61},      {"touching", 61}};
inline constexpr Budget kOfPerturbedInvalidHull[] = {
    {"boxes", 200},          {"capsules", 3400},
    {"cores_touch", 400000}, {"corner_corner", 1400},
    {"deep", 2400},          {"grid", 400},
    {"in_line", 1200},       {"micro_edge", 4200},
    {"mixed_shapes", 4400},  {"near_collinear", 1600},
    {"near_parallel", 200},  {"round_corners", 13000},
    {"scaled", 11000},       {"side_planes", 1600},
    {"sliver", 1000},        {"tie_bias", 5600},
    {"tied_faces", 3000},    {"tilted_edges", 400},
    {"ulp", 2200},           {"voronoi_lines", 5200}};
inline constexpr Budget kOfPerturbedBesideFace[] = {
    {"cores_touch", 200},    {"corner_corner", 2400}, {"in_line", 310},  {"micro_edge", 3000},
    {"mixed_shapes", 200},   {"near_parallel", 200},  {"regular", 400},  {"sliver", 600},
    {"tied_faces", 2500},    {"touching", 400},       {"ulp", 730},      {"grid", 60},
    {"near_collinear", 180}, {"off_unit", 61},        {"tie_bias", 4200}};
inline constexpr Budget kOfPerturbedChord[] = {{"capsules", 20000},      {"cores_touch", 230000},
                                               {"in_line", 150000},      {"mixed_shapes", 15000},
                                               {"round_corners", 27000}, {"side_planes", 2600},
                                               {"tilted_edges", 15000},  {"voronoi_lines", 8400}};
inline constexpr Budget kOfPerturbedInnerFace[] = {{"near_collinear", 300}, {"near_parallel", 400},
                                                   {"sliver", 4800},        {"micro_edge", 120},
                                                   {"tied_faces", 180},     {"ulp", 130}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletEpa{
    LedgerEntry{.id = "bullet-epa-touching-axis",
                .collider = "bullet-epa",
                .description =
                    "cores within 0.001 of touching: the loop ends before it renews the "
                    "distance, so the normal is that of two points that nearly coincide, and "
                    "the point is moved to the surface by the step before's distance",
                .source = kDetectorKeepsAxis,
                .budgets = kOfBulletEpaTouchingAxis,
                .explains = axis_of_touching_cores<BulletAsked::epa>},
    LedgerEntry{
        .id = "bullet-epa-near-corner",
        .collider = "bullet-epa",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .budgets = kOfBulletEpaNearCorner,
        .explains = stopped_at_near_corner<BulletAsked::epa>},
    LedgerEntry{.id = "bullet-epa-relative-error",
                .collider = "bullet-epa",
                .description = "the query ends where its squared distance, 1e18 at first, falls by "
                               "less than a millionth",
                .source = kRelativeErrorEnds,
                .budgets = kOfBulletEpaRelativeError,
                .explains = stopped_by_relative_error<BulletAsked::epa>},
    LedgerEntry{
        .id = "bullet-epa-flat-simplex",
        .collider = "bullet-epa",
        .description = "the query ends at four corners in a plane, within 0.0001 of a determinant",
        .source = kFlatSimplex,
        .budgets = kOfBulletEpaFlatSimplex,
        .explains = stopped_at_flat_simplex<BulletAsked::epa>},
    LedgerEntry{
        .id = "bullet-epa-turned-back",
        .collider = "bullet-epa",
        .description = "the normal is reversed by what compares distances along both directions",
        .source = kTurnedBack,
        .budgets = kOfBulletEpaTurnedBack,
        .explains = normal_turned_back<BulletAsked::epa>},
    LedgerEntry{.id = "bullet-epa-gjk-apart",
                .collider = "bullet-epa",
                .description =
                    "the GJK of the EPA finds them apart, ended by a corner within 0.01 of another",
                .source = kGjkApart,
                .budgets = kOfBulletEpaGjkApart,
                .explains = epa_finds_apart},
    LedgerEntry{
        .id = "bullet-epa-fall-back",
        .collider = "bullet-epa",
        .description = "EPA finds no tetrahedron about the origin: its guess, and a depth of 0",
        .source = kFallBack,
        .budgets = kOfBulletEpaFallBack,
        .explains = epa_falls_back},
    LedgerEntry{
        .id = "bullet-epa-invalid-hull",
        .collider = "bullet-epa",
        .description = "EPA ends at a hull that it cannot expand, with the face that it had",
        .source = kInvalidHull,
        .budgets = kOfBulletEpaInvalidHull,
        .explains = epa_at_invalid_hull},
    LedgerEntry{
        .id = "bullet-epa-beside-face",
        .collider = "bullet-epa",
        .description = "the depth of a face's edge along the face's normal, the point off the face",
        .source = kBesideFace,
        .budgets = kOfBulletEpaBesideFace,
        .explains = epa_beside_face},
    LedgerEntry{.id = "bullet-epa-chord",
                .collider = "bullet-epa",
                .description = "a face within 0.0001 of a curved shape, and not tangent to it",
                .source = kChord,
                .budgets = kOfBulletEpaChord,
                .explains = epa_at_chord},
    LedgerEntry{.id = "bullet-epa-axis-of-roundings",
                .collider = "bullet-epa",
                .description = "the direction between the closest points of cores so near that the "
                               "roundings of these turn it",
                .source = kDetectorAxis,
                .budgets = kOfBulletEpaAxisOfRoundings,
                .explains = axis_turned_by_roundings<BulletAsked::epa>},
    LedgerEntry{.id = "bullet-epa-inner-face",
                .collider = "bullet-epa",
                .description = "a face within 0.0001 of the difference's corners, and inside of it",
                .source = kChord,
                .budgets = kOfBulletEpaInnerFace,
                .explains = epa_at_inner_face},
};

/// Of bullet-perturbed, the same of its first query.
inline constexpr std::array kOfBulletPerturbedEpa{
    LedgerEntry{.id = "bullet-perturbed-gjk-apart",
                .collider = "bullet-perturbed",
                .description =
                    "the GJK of the EPA finds them apart, ended by a corner within 0.01 of another",
                .source = kGjkApart,
                .budgets = kOfPerturbedGjkApart,
                .explains = of_first_query<epa_finds_apart>},
    LedgerEntry{
        .id = "bullet-perturbed-fall-back",
        .collider = "bullet-perturbed",
        .description = "EPA finds no tetrahedron about the origin: its guess, and a depth of 0",
        .source = kFallBack,
        .budgets = kOfPerturbedFallBack,
        .explains = of_first_query<epa_falls_back>},
    LedgerEntry{
        .id = "bullet-perturbed-invalid-hull",
        .collider = "bullet-perturbed",
        .description = "EPA ends at a hull that it cannot expand, with the face that it had",
        .source = kInvalidHull,
        .budgets = kOfPerturbedInvalidHull,
        .explains = of_first_query<epa_at_invalid_hull>},
    LedgerEntry{
        .id = "bullet-perturbed-beside-face",
        .collider = "bullet-perturbed",
        .description = "the depth of a face's edge along the face's normal, the point off the face",
        .source = kBesideFace,
        .budgets = kOfPerturbedBesideFace,
        .explains = of_first_query<epa_beside_face>},
    LedgerEntry{.id = "bullet-perturbed-chord",
                .collider = "bullet-perturbed",
                .description = "a face within 0.0001 of a curved shape, and not tangent to it",
                .source = kChord,
                .budgets = kOfPerturbedChord,
                .explains = of_first_query<epa_at_chord>},
    LedgerEntry{.id = "bullet-perturbed-inner-face",
                .collider = "bullet-perturbed",
                .description = "a face within 0.0001 of the difference's corners, and inside of it",
                .source = kChord,
                .budgets = kOfPerturbedInnerFace,
                .explains = of_first_query<epa_at_inner_face>},
};

}  // namespace manifuzz::ledger_of
