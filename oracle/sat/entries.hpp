#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/sat/deviations.hpp"

namespace manifuzz::ledger_of {

// SAT.js 0.9.0, in double. Budgets are twice what 300,000 cases against clip64 showed, or another
// million, rounded up.
inline constexpr Budget kOfSatExactTouch[] = {
    {"boxes", 970},       {"corner_corner", 2400},  {"corner_face", 20000},  {"grid", 460000},
    {"micro_edge", 9300}, {"near_collinear", 8200}, {"near_parallel", 7200}, {"off_unit", 2200},
    {"regular", 200},     {"scaled", 4100},         {"sliver", 9100},        {"tie_bias", 970},
    {"tied_faces", 7200}, {"touching", 38000},      {"ulp", 13000}};
inline constexpr Budget kOfSatOneCentre[] = {{"cores_touch", 630000}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfSat{
    LedgerEntry{
        .id = "sat-axis-of-exact-touch",
        .collider = "sat",
        .description = "the normal reversed, at depth 0: of polygons that just touch, the axis is "
                       "not turned about",
        .source =
            "sat 0.9.0, SAT.js, isSeparatingAxis: if (overlap < 0) response['overlapN'].reverse()",
        .budgets = kOfSatExactTouch,
        .explains = axis_of_exact_touch_in_sat},
    LedgerEntry{.id = "sat-one-centre",
                .collider = "sat",
                .description = "a normal of no length: the centres of two circles are at one place",
                .source = "sat 0.9.0, SAT.js, testCircleCircle: differenceV.normalize(), which "
                          "leaves what has no length",
                .budgets = kOfSatOneCentre,
                .explains = no_normal_of_one_centre_in_sat},
};

}  // namespace manifuzz::ledger_of
