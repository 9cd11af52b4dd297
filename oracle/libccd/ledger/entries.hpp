#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/libccd/ledger/deviations.hpp"
#include "oracle/libccd/ledger/polytope_deviations.hpp"
#include "oracle/libccd/ledger/ray.hpp"

namespace manifuzz::ledger_of {

// libccd 2.1, in double. Budgets are twice what 1,000,000 cases against clip64 showed, of what is
// repeated in its own doubles 300,000, or 1,000,000 where those show more, rounded up.
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
                                                       {"touching", 1500},
                                                       {"ulp", 44000}};
inline constexpr Budget kOfLibccdGjkLeftAtOwnCorner[] = {
    {"deep", 22000},  {"grid", 1200},  {"near_collinear", 140},
    {"scaled", 4200}, {"sliver", 270}, {"tied_faces", 3100},
    {"ulp", 940}};
inline constexpr Budget kOfLibccdGjkLeftAtZero[] = {
    {"deep", 800},          {"grid", 6700},   {"micro_edge", 270}, {"near_collinear", 940},
    {"near_parallel", 540}, {"regular", 400}, {"sliver", 270},     {"tied_faces", 3100},
    {"touching", 140},      {"ulp", 400}};
inline constexpr Budget kOfLibccdGjkLeftTouching[] = {{"micro_edge", 270},
                                                      {"near_collinear", 670},
                                                      {"near_parallel", 270},
                                                      {"tied_faces", 400},
                                                      {"ulp", 270}};
inline constexpr Budget kOfLibccdMprCornerOfRay[] = {
    {"boxes", 400},         {"deep", 500000},         {"sliver", 6200},   {"ulp", 27000},
    {"corner_corner", 720}, {"far_from_origin", 120}, {"grid", 3000},     {"micro_edge", 80},
    {"near_collinear", 40}, {"off_unit", 160},        {"regular", 12000}, {"scaled", 1400},
    {"tie_bias", 280},      {"tied_faces", 97000},    {"touching", 3600}};

inline constexpr Budget kOfLibccdGjkWithoutOrigin[] = {
    {"grid", 140}, {"scaled", 1400}, {"ulp", 140}};
inline constexpr Budget kOfLibccdGjkFolded[] = {
    {"grid", 1600}, {"sliver", 140}, {"tied_faces", 270}};
inline constexpr Budget kOfLibccdGjkApartByZero[] = {
    {"micro_edge", 140}, {"near_collinear", 1200}, {"near_parallel", 270},
    {"scaled", 140},     {"tied_faces", 540},      {"ulp", 270}};
inline constexpr Budget kOfLibccdGjkNoDirection[] = {
    {"boxes", 270},       {"corner_corner", 2300},  {"corner_face", 6300},   {"grid", 560000},
    {"micro_edge", 4000}, {"near_collinear", 4000}, {"near_parallel", 2400}, {"off_unit", 2000},
    {"regular", 800},     {"scaled", 3200},         {"sliver", 5800},        {"tie_bias", 270},
    {"tied_faces", 3400}, {"touching", 27000},      {"ulp", 16000}};
inline constexpr Budget kOfLibccdGjkEndless[] = {{"scaled", 1400}, {"ulp", 140}};
inline constexpr Budget kOfLibccdMprEdgeOfPortal[] = {{"deep", 290000},
                                                      {"grid", 18000},
                                                      {"micro_edge", 52000},
                                                      {"near_collinear", 33000},
                                                      {"near_parallel", 24000},
                                                      {"sliver", 130000},
                                                      {"ulp", 50000},
                                                      {"boxes", 3100},
                                                      {"corner_corner", 11000},
                                                      {"corner_face", 37000},
                                                      {"far_from_origin", 37000},
                                                      {"generic", 22000},
                                                      {"off_unit", 33000},
                                                      {"regular", 2300},
                                                      {"scaled", 25000},
                                                      {"tie_bias", 52000},
                                                      {"tied_faces", 25000},
                                                      {"touching", 6000}};

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
        .explains = by_ccd<zero_of_squares>},
    LedgerEntry{.id = "libccd-gjk-tolerance-of-squares",
                .collider = "libccd-gjk",
                .description = "too little depth along another normal: the tolerance, a length, is "
                               "compared with squares of lengths",
                .source = "libccd 2.1, src/ccd.c, nextSupport: dist - el->dist < epa_tolerance",
                .budgets = kOfLibccdGjkToleranceOfSquares,
                .explains = by_ccd<tolerance_of_squares>},
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
    LedgerEntry{
        .id = "libccd-gjk-without-origin",
        .collider = "libccd-gjk",
        .description = "another face's depth, or contact across a gap: the simplex does not hold "
                       "the origin, as roundings above 2.2e-16 decide",
        .source =
            "libccd 2.1, src/ccd.c, doSimplex2 to doSimplex4: ccdIsZero, ccdSign; src/vec3.c, "
            "ccdVec3PointTriDist2: a square as a sum of six",
        .budgets = kOfLibccdGjkWithoutOrigin,
        .explains = polytope_without_origin},
    LedgerEntry{.id = "libccd-gjk-folded",
                .collider = "libccd-gjk",
                .description = "another face's depth: eight triangles about the two corners that "
                               "GJK ends with are folded, and the origin is outside",
                .source = "libccd 2.1, src/ccd.c, simplexToPolytope2: supp[0] is any corner",
                .budgets = kOfLibccdGjkFolded,
                .explains = polytope_folded},
    LedgerEntry{.id = "libccd-gjk-apart-by-zero",
                .collider = "libccd-gjk",
                .description = "no contact: a tetrahedron seems flat, or a direction of no length, "
                               "as squares below 2.2e-16 are 0",
                .source = "libccd 2.1, src/ccd.c, doSimplex4: ccdIsZero(dist), return -1; "
                          "__ccdGJK: ccdIsZero(ccdVec3Len2(&dir))",
                .budgets = kOfLibccdGjkApartByZero,
                .explains = apart_by_zero},
    LedgerEntry{.id = "libccd-gjk-no-direction",
                .collider = "libccd-gjk",
                .description = "a depth of 0 along 0 / 0: the origin is on the nearest element",
                .source = "libccd 2.1, src/ccd.c, ccdGJKPenetration: ccdVec3Normalize of "
                          "nearest->witness",
                .budgets = kOfLibccdGjkNoDirection,
                .explains_lost = direction_of_no_length},
    LedgerEntry{.id = "libccd-gjk-endless",
                .collider = "libccd-gjk",
                .description =
                    "never an answer: the same triangles are expanded by the same corners "
                    "again and again",
                .source = "libccd 2.1, src/ccd.c, __ccdGJKEPA: while (1), without max_iterations",
                .budgets = kOfLibccdGjkEndless,
                .explains_lost = polytope_expanded_for_ever},
    LedgerEntry{.id = "libccd-mpr-face-of-ray",
                .collider = "libccd-mpr",
                .description = "the face through which the ray from the centres leaves the "
                               "difference, and not the nearest one",
                .source =
                    "libccd 2.1, src/mpr.c, findPenetr: ccdVec3PointTriDist2 of the portal that "
                    "the ray from v0 leaves",
                .budgets = kOfLibccdMprFaceOfRay,
                .explains = translation_to_portal},
    LedgerEntry{.id = "libccd-mpr-corner-of-ray",
                .collider = "libccd-mpr",
                .description = "a corner, where the origin is on the line from the difference's "
                               "middle to it, and not the nearest face",
                .source = "libccd 2.1, src/mpr.c, discoverPortal: ccdIsZero(ccdVec3Len2(&dir)), "
                          "return 2; findPenetrSegment: depth is that of v1",
                .budgets = kOfLibccdMprCornerOfRay,
                .explains = translation_to_corner_of_ray},
    LedgerEntry{.id = "libccd-mpr-edge-of-portal",
                .collider = "libccd-mpr",
                .description = "a place on the edge of the one triangle that the ray leaves by, at "
                               "no right angle to it",
                .source = "libccd 2.1, src/mpr.c, findPenetr: ccdVec3PointTriDist2 of v1, v2, v3",
                .budgets = kOfLibccdMprEdgeOfPortal,
                .explains = translation_to_edge_of_portal},
};

}  // namespace manifuzz::ledger_of
