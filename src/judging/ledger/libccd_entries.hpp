#pragma once

#include <array>

#include "judging/ledger/gjk_deviations.hpp"

namespace manifuzz::ledger_of {

// libccd 2.1, in double.

/// The entries, the first that explains before others.
inline constexpr std::array kOfLibccd{
    LedgerEntry{.id = "libccd-gjk-direction-of-roundings",
                .collider = "libccd-gjk",
                .description = "the normal of shapes that hardly touch is that of roundings",
                .source = "libccd 2.1, src/ccd.c, ccdGJKPenetration: ccdVec3Normalize(dir)",
                .budgets = {},
                .explains = direction_of_short_translation},
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
                .source = "libccd 2.1, src/mpr.c, findPenetr",
                .budgets = {},
                .explains = translation_to_face_of_ray},
};

}  // namespace manifuzz::ledger_of
