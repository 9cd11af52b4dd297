#pragma once

#include <functional>
#include <span>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// Chipmunk's `cpShapesCollide` through all pairs once, both shapes brought up to date with their
/// transforms before, as its space does for every body that moved.
std::function<void()> chipmunk_pass(std::span<const PairCase> pairs);

}  // namespace manifuzz
