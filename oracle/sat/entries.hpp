#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/sat/deviations.hpp"

namespace manifuzz::ledger_of {

// SAT.js 0.9.0, in double. Budgets (budgets.json) are twice what 300,000 cases against clip64
// showed, or another million, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfSat{
    LedgerEntry{
        .id = "sat-axis-of-exact-touch",
        .collider = "sat",
        .description = "the normal reversed, at depth 0: of polygons that just touch, the axis is "
                       "not turned about",
        .source =
            "sat 0.9.0, SAT.js, isSeparatingAxis: if (overlap < 0) response['overlapN'].reverse()",
        .explains = axis_of_exact_touch_in_sat},
    LedgerEntry{.id = "sat-one-centre",
                .collider = "sat",
                .description = "a normal of no length: the centres of two circles are at one place",
                .source = "sat 0.9.0, SAT.js, testCircleCircle: differenceV.normalize(), which "
                          "leaves what has no length",
                .explains = no_normal_of_one_centre_in_sat},
};

}  // namespace manifuzz::ledger_of
