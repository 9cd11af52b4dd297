#pragma once

#include <array>

#include "oracle/bullet/ledger/perturbed_deviations.hpp"
#include "oracle/bullet/ledger/query_entries.hpp"

namespace manifuzz::ledger_of {

// Bullet 3.24, its query repeated in float. Budgets (budgets.json) are twice what 300,000 cases
// against clip64 showed, or 1,000,000 where those show more, rounded up.

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

/// The entries, the first that explains before others.
inline constexpr std::array kOfBulletEpa{
    LedgerEntry{.id = "bullet-epa-touching-axis",
                .collider = "bullet-epa",
                .description =
                    "cores within 0.001 of touching: the loop ends before it renews the "
                    "distance, so the normal is that of two points that nearly coincide, and "
                    "the point is moved to the surface by the step before's distance",
                .source = kDetectorKeepsAxis,
                .explains = axis_of_touching_cores<BulletAsked::epa>},
    LedgerEntry{
        .id = "bullet-epa-near-corner",
        .collider = "bullet-epa",
        .description =
            "the query ends at a corner within 0.01 of another, short of the closest points",
        .source = kNearCorner,
        .explains = stopped_at_near_corner<BulletAsked::epa>},
    LedgerEntry{.id = "bullet-epa-relative-error",
                .collider = "bullet-epa",
                .description = "the query ends where its squared distance, 1e18 at first, falls by "
                               "less than a millionth",
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
    LedgerEntry{.id = "bullet-epa-inner-face",
                .collider = "bullet-epa",
                .description = "a face within 0.0001 of the difference's corners, and inside of it",
                .source = kChord,
                .explains = epa_at_inner_face},
};

/// The entries of bullet-perturbed on its first query.
inline constexpr std::array kOfBulletPerturbedEpa{
    LedgerEntry{.id = "bullet-perturbed-gjk-apart",
                .collider = "bullet-perturbed",
                .description =
                    "the GJK of the EPA finds them apart, ended by a corner within 0.01 of another",
                .source = kGjkApart,
                .explains = of_first_query<epa_finds_apart>},
    LedgerEntry{
        .id = "bullet-perturbed-fall-back",
        .collider = "bullet-perturbed",
        .description = "EPA finds no tetrahedron about the origin: its guess, and a depth of 0",
        .source = kFallBack,
        .explains = of_first_query<epa_falls_back>},
    LedgerEntry{
        .id = "bullet-perturbed-invalid-hull",
        .collider = "bullet-perturbed",
        .description = "EPA ends at a hull that it cannot expand, with the face that it had",
        .source = kInvalidHull,
        .explains = of_first_query<epa_at_invalid_hull>},
    LedgerEntry{
        .id = "bullet-perturbed-beside-face",
        .collider = "bullet-perturbed",
        .description = "the depth of a face's edge along the face's normal, the point off the face",
        .source = kBesideFace,
        .explains = of_first_query<epa_beside_face>},
    LedgerEntry{.id = "bullet-perturbed-chord",
                .collider = "bullet-perturbed",
                .description = "a face within 0.0001 of a curved shape, and not tangent to it",
                .source = kChord,
                .explains = of_first_query<epa_at_chord>},
    LedgerEntry{.id = "bullet-perturbed-inner-face",
                .collider = "bullet-perturbed",
                .description = "a face within 0.0001 of the difference's corners, and inside of it",
                .source = kChord,
                .explains = of_first_query<epa_at_inner_face>},
};

}  // namespace manifuzz::ledger_of
