#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/libccd/ledger/deviations.hpp"
#include "oracle/libccd/ledger/polytope_deviations.hpp"
#include "oracle/libccd/ledger/ray.hpp"

namespace manifuzz::ledger_of {

// libccd 2.1, in double. Budgets (budgets.json) are twice what 1,000,000 cases against clip64
// showed, of what is repeated in its own doubles 300,000, or 1,000,000 where those show more,
// rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfLibccd{
    LedgerEntry{
        .id = "libccd-gjk-zero-of-squares",
        .collider = "libccd-gjk",
        .description =
            "another normal, or contact, within 1.5e-8 of touching: squares below 2.2e-16 "
            "are 0",
        .source = "libccd 2.1, src/ccd.c, doSimplex3, nextSupport: ccdIsZero(dist) of a square",
        .explains = by_ccd<zero_of_squares>},
    LedgerEntry{.id = "libccd-gjk-tolerance-of-squares",
                .collider = "libccd-gjk",
                .description = "too little depth along another normal: the tolerance, a length, is "
                               "compared with squares of lengths",
                .source = "libccd 2.1, src/ccd.c, nextSupport: dist - el->dist < epa_tolerance",
                .explains = by_ccd<tolerance_of_squares>},
    LedgerEntry{
        .id = "libccd-gjk-left-by-squares",
        .collider = "libccd-gjk",
        .description = "the same tolerance ends the search at a face that leans out of the plane",
        .source = "libccd 2.1, src/ccd.c, nextSupport: dist - el->dist < epa_tolerance, "
                  "dist < epa_tolerance",
        .explains = polytope_left_by_squares},
    LedgerEntry{.id = "libccd-gjk-left-at-own-corner",
                .collider = "libccd-gjk",
                .description = "an element inside the difference: expanded by one triangle at a "
                               "time, the polytope is not convex",
                .source = "libccd 2.1, src/ccd.c, expandPolytope; nextSupport: "
                          "ccdVec3PointTriDist2 < epa_tolerance",
                .explains = polytope_left_at_own_corner},
    LedgerEntry{.id = "libccd-gjk-left-at-zero",
                .collider = "libccd-gjk",
                .description =
                    "almost no depth: the origin is on a face of the polytope, inside the "
                    "difference",
                .source = "libccd 2.1, src/ccd.c, nextSupport: ccdIsZero(el->dist)",
                .explains = polytope_left_at_zero},
    LedgerEntry{.id = "libccd-gjk-left-touching",
                .collider = "libccd-gjk",
                .description =
                    "almost no depth: a triangle about the origin is taken for one of the "
                    "difference's boundary",
                .source = "libccd 2.1, src/ccd.c, simplexToPolytope3: ccdIsZero(dist)",
                .explains = polytope_left_touching},
    LedgerEntry{
        .id = "libccd-gjk-without-origin",
        .collider = "libccd-gjk",
        .description = "another face's depth, or contact across a gap: the simplex does not hold "
                       "the origin, as roundings above 2.2e-16 decide",
        .source =
            "libccd 2.1, src/ccd.c, doSimplex2 to doSimplex4: ccdIsZero, ccdSign; src/vec3.c, "
            "ccdVec3PointTriDist2: a square as a sum of six",
        .explains = polytope_without_origin},
    LedgerEntry{.id = "libccd-gjk-folded",
                .collider = "libccd-gjk",
                .description = "another face's depth: eight triangles about the two corners that "
                               "GJK ends with are folded, and the origin is outside",
                .source = "libccd 2.1, src/ccd.c, simplexToPolytope2: supp[0] is any corner",
                .explains = polytope_folded},
    LedgerEntry{.id = "libccd-gjk-apart-by-zero",
                .collider = "libccd-gjk",
                .description = "no contact: a tetrahedron seems flat, or a direction of no length, "
                               "as squares below 2.2e-16 are 0",
                .source = "libccd 2.1, src/ccd.c, doSimplex4: ccdIsZero(dist), return -1; "
                          "__ccdGJK: ccdIsZero(ccdVec3Len2(&dir))",
                .explains = apart_by_zero},
    LedgerEntry{.id = "libccd-gjk-no-direction",
                .collider = "libccd-gjk",
                .description = "a depth of 0 along 0 / 0: the origin is on the nearest element",
                .source = "libccd 2.1, src/ccd.c, ccdGJKPenetration: ccdVec3Normalize of "
                          "nearest->witness",
                .explains_lost = direction_of_no_length},
    LedgerEntry{.id = "libccd-gjk-endless",
                .collider = "libccd-gjk",
                .description =
                    "never an answer: the same triangles are expanded by the same corners "
                    "again and again",
                .source = "libccd 2.1, src/ccd.c, __ccdGJKEPA: while (1), without max_iterations",
                .explains_lost = polytope_expanded_for_ever},
    LedgerEntry{.id = "libccd-mpr-face-of-ray",
                .collider = "libccd-mpr",
                .description = "the face through which the ray from the centres leaves the "
                               "difference, and not the nearest one",
                .source =
                    "libccd 2.1, src/mpr.c, findPenetr: ccdVec3PointTriDist2 of the portal that "
                    "the ray from v0 leaves",
                .explains = translation_to_portal},
    LedgerEntry{.id = "libccd-mpr-corner-of-ray",
                .collider = "libccd-mpr",
                .description = "a corner, where the origin is on the line from the difference's "
                               "middle to it, and not the nearest face",
                .source = "libccd 2.1, src/mpr.c, discoverPortal: ccdIsZero(ccdVec3Len2(&dir)), "
                          "return 2; findPenetrSegment: depth is that of v1",
                .explains = translation_to_corner_of_ray},
    LedgerEntry{.id = "libccd-mpr-edge-of-portal",
                .collider = "libccd-mpr",
                .description = "a place on the edge of the one triangle that the ray leaves by, at "
                               "no right angle to it",
                .source = "libccd 2.1, src/mpr.c, findPenetr: ccdVec3PointTriDist2 of v1, v2, v3",
                .explains = translation_to_edge_of_portal},
};

}  // namespace manifuzz::ledger_of
