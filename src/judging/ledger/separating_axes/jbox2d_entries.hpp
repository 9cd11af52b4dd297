#pragma once

#include <array>

#include "judging/ledger/separating_axes/axes_deviations.hpp"

namespace manifuzz::ledger_of {

// What jbox2d 2.2.1.1 has of Box2D 2.2's search for the best face, in float. Budgets are twice what
// 300,000 cases against clip64 showed, rounded up.
inline constexpr Budget kOfJbox2dLocalMaximum[] = {
    {"deep", 170000}, {"micro_edge", 19000}, {"near_collinear", 800}, {"scaled", 200},
    {"sliver", 4200}, {"tied_faces", 1600},  {"ulp", 15000}};

inline constexpr std::array kOfJbox2dSearch{
    LedgerEntry{.id = "jbox2d-local-maximum",
                .collider = "jbox2d",
                .description = "another face, or no contact: the search from the direction between "
                               "the centroids ends at a local maximum of the separation",
                .source = "jbox2d 2.2.1.1, org/jbox2d/collision/Collision.java, findMaxSeparation: "
                          "s > bestSeparation, else break",
                .budgets = kOfJbox2dLocalMaximum,
                .explains = local_maximum_in_jbox2d},
};

}  // namespace manifuzz::ledger_of
