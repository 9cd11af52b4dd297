#pragma once

#include <array>

#include "judging/ledger/gjk_deviations.hpp"

namespace manifuzz::ledger_of {

// libccd 2.1, in double.

/// The entries, the first that explains before others.
inline constexpr std::array kOfLibccd{
    LedgerEntry{
        .id = "libccd-gjk-zero-of-squares",
        .collider = "libccd-gjk",
        .description =
            "another normal, or contact, within 1.5e-8 of touching: squares below 2.2e-16 "
            "are 0",
        .source = "libccd 2.1, src/ccd.c, doSimplex3, nextSupport: ccdIsZero(dist) of a square",
        .budgets = {},
        .explains = zero_of_squares},
    LedgerEntry{.id = "libccd-gjk-tolerance-of-squares",
                .collider = "libccd-gjk",
                .description = "too little depth along another normal: the tolerance, a length, is "
                               "compared with squares of lengths",
                .source = "libccd 2.1, src/ccd.c, nextSupport: dist - el->dist < epa_tolerance",
                .budgets = {},
                .explains = tolerance_of_squares},
    LedgerEntry{.id = "libccd-mpr-face-of-ray",
                .collider = "libccd-mpr",
                .description = "the face through which the ray from the centres leaves the "
                               "difference, and not the nearest one",
                .source =
                    "libccd 2.1, src/mpr.c, findPenetr: ccdVec3PointTriDist2 of the portal that "
                    "the ray from v0 leaves",
                .budgets = {},
                .explains = translation_to_face_of_ray},
};

}  // namespace manifuzz::ledger_of
