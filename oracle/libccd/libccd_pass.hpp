#pragma once

#include <functional>
#include <span>

#include "geometry/pair_case.hpp"

namespace manifuzz {

// One query of libccd through all pairs once, the prisms made before; empty where libccd is not
// installed.

/// A pass of ccdGJKPenetration.
std::function<void()> libccd_gjk_pass(std::span<const PairCase> pairs);
/// A pass of ccdMPRPenetration.
std::function<void()> libccd_mpr_pass(std::span<const PairCase> pairs);

}  // namespace manifuzz
