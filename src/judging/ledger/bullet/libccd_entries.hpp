#pragma once

#include <array>

#include "judging/ledger/bullet/ccd_deviations.hpp"
#include "judging/ledger/bullet/libccd_ray.hpp"
#include "judging/ledger/gjk_deviations.hpp"

namespace manifuzz::ledger_of {

// libccd 2.1, in double. Budgets are twice what 1,000,000 cases against clip64 showed, rounded up.
inline constexpr Budget kOfLibccdGjkZeroOfSquares[] = {{"generic", 12000},
                                                       {"boxes", 13000},
                                                       {"regular", 9600},
                                                       {"grid", 180000},
                                                       {"sliver", 39000},
                                                       {"near_parallel", 24000},
                                                       {"tied_faces", 23000},
                                                       {"micro_edge", 26000},
                                                       {"near_collinear", 21000},
                                                       {"corner_corner", 16000},
                                                       {"corner_face", 25000},
                                                       {"touching", 66000},
                                                       {"tie_bias", 13000},
                                                       {"far_from_origin", 14000},
                                                       {"scaled", 34000},
                                                       {"off_unit", 16000},
                                                       {"ulp", 27000}};
inline constexpr Budget kOfLibccdGjkToleranceOfSquares[] = {{"generic", 33000},
                                                            {"boxes", 5400},
                                                            {"regular", 24000},
                                                            {"grid", 600},
                                                            {"sliver", 310000},
                                                            {"near_parallel", 130000},
                                                            {"tied_faces", 150000},
                                                            {"micro_edge", 150000},
                                                            {"near_collinear", 88000},
                                                            {"corner_corner", 230000},
                                                            {"corner_face", 49000},
                                                            {"touching", 82000},
                                                            {"deep", 210000},
                                                            {"tie_bias", 250000},
                                                            {"far_from_origin", 120000},
                                                            {"scaled", 80000},
                                                            {"off_unit", 130000},
                                                            {"ulp", 120000}};
inline constexpr Budget kOfLibccdMprFaceOfRay[] = {
    {"generic", 41000},       {"boxes", 21000},        {"regular", 25000},
    {"grid", 370000},         {"sliver", 240000},      {"near_parallel", 47000},
    {"tied_faces", 150000},   {"micro_edge", 220000},  {"near_collinear", 74000},
    {"corner_corner", 39000}, {"corner_face", 120000}, {"touching", 71000},
    {"deep", 1000000},        {"tie_bias", 170000},    {"far_from_origin", 110000},
    {"scaled", 150000},       {"off_unit", 120000},    {"ulp", 180000}};

inline constexpr Budget kOfLibccdGjkLeftBySquares[] = {{"boxes", 1800},
                                                       {"corner_corner", 5200},
                                                       {"corner_face", 32000},
                                                       {"deep", 100000},
                                                       {"far_from_origin", 38000},
                                                       {"generic", 14000},
                                                       {"micro_edge", 96000},
                                                       {"near_collinear", 48000},
                                                       {"near_parallel", 36000},
                                                       {"off_unit", 35000},
                                                       {"regular", 4400},
                                                       {"scaled", 57000},
                                                       {"sliver", 130000},
                                                       {"tie_bias", 45000},
                                                       {"tied_faces", 62000},
                                                       {"touching", 1400},
                                                       {"ulp", 44000}};
inline constexpr Budget kOfLibccdGjkLeftAtOwnCorner[] = {
    {"deep", 22000},      {"grid", 540}, {"near_collinear", 140}, {"scaled", 4200}, {"sliver", 270},
    {"tied_faces", 3000}, {"ulp", 940}};
inline constexpr Budget kOfLibccdGjkLeftAtZero[] = {
    {"deep", 800},          {"grid", 6600},   {"micro_edge", 270}, {"near_collinear", 940},
    {"near_parallel", 540}, {"regular", 400}, {"sliver", 270},     {"tied_faces", 3100},
    {"touching", 140},      {"ulp", 400}};
inline constexpr Budget kOfLibccdGjkLeftTouching[] = {{"micro_edge", 270},
                                                      {"near_collinear", 670},
                                                      {"near_parallel", 270},
                                                      {"tied_faces", 400},
                                                      {"ulp", 270}};
inline constexpr Budget kOfLibccdMprCornerOfRay[] = {
    {"boxes", 400}, {"deep", 150000}, {"sliver", 2800}, {"ulp", 7000}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfLibccd{
    LedgerEntry{
        .id = "libccd-gjk-zero-of-squares",
        .collider = "libccd-gjk",
        .description =
            "another normal, or contact, within 1.5e-8 of touching: squares below 2.2e-16 "
            "are 0",
        .source = "libccd 2.1, src/ccd.c, doSimplex3, nextSupport: ccdIsZero(dist) of a square",
        .budgets = kOfLibccdGjkZeroOfSquares,
        .explains = zero_of_squares},
    LedgerEntry{.id = "libccd-gjk-tolerance-of-squares",
                .collider = "libccd-gjk",
                .description = "too little depth along another normal: the tolerance, a length, is "
                               "compared with squares of lengths",
                .source = "libccd 2.1, src/ccd.c, nextSupport: dist - el->dist < epa_tolerance",
                .budgets = kOfLibccdGjkToleranceOfSquares,
                .explains = tolerance_of_squares},
    LedgerEntry{
        .id = "libccd-gjk-left-by-squares",
        .collider = "libccd-gjk",
        .description = "the same tolerance ends the search at a face that leans out of the plane",
        .source = "libccd 2.1, src/ccd.c, nextSupport: dist - el->dist < epa_tolerance, "
                  "dist < epa_tolerance",
        .budgets = kOfLibccdGjkLeftBySquares,
        .explains = polytope_left_by_squares},
    LedgerEntry{.id = "libccd-gjk-left-at-own-corner",
                .collider = "libccd-gjk",
                .description = "an element inside the difference: expanded by one triangle at a "
                               "time, the polytope is not convex",
                .source = "libccd 2.1, src/ccd.c, expandPolytope; nextSupport: "
                          "ccdVec3PointTriDist2 < epa_tolerance",
                .budgets = kOfLibccdGjkLeftAtOwnCorner,
                .explains = polytope_left_at_own_corner},
    LedgerEntry{.id = "libccd-gjk-left-at-zero",
                .collider = "libccd-gjk",
                .description =
                    "almost no depth: the origin is on a face of the polytope, inside the "
                    "difference",
                .source = "libccd 2.1, src/ccd.c, nextSupport: ccdIsZero(el->dist)",
                .budgets = kOfLibccdGjkLeftAtZero,
                .explains = polytope_left_at_zero},
    LedgerEntry{.id = "libccd-gjk-left-touching",
                .collider = "libccd-gjk",
                .description =
                    "almost no depth: a triangle about the origin is taken for one of the "
                    "difference's boundary",
                .source = "libccd 2.1, src/ccd.c, simplexToPolytope3: ccdIsZero(dist)",
                .budgets = kOfLibccdGjkLeftTouching,
                .explains = polytope_left_touching},
    LedgerEntry{.id = "libccd-mpr-face-of-ray",
                .collider = "libccd-mpr",
                .description = "the face through which the ray from the centres leaves the "
                               "difference, and not the nearest one",
                .source =
                    "libccd 2.1, src/mpr.c, findPenetr: ccdVec3PointTriDist2 of the portal that "
                    "the ray from v0 leaves",
                .budgets = kOfLibccdMprFaceOfRay,
                .explains = translation_to_face_of_ray},
    LedgerEntry{.id = "libccd-mpr-corner-of-ray",
                .collider = "libccd-mpr",
                .description = "a corner, where the origin is on the line from the difference's "
                               "middle to it, and not the nearest face",
                .source = "libccd 2.1, src/mpr.c, discoverPortal: ccdIsZero(ccdVec3Len2(&dir)), "
                          "return 2; findPenetrSegment: depth is that of v1",
                .budgets = kOfLibccdMprCornerOfRay,
                .explains = translation_to_corner_of_ray},
};

}  // namespace manifuzz::ledger_of
