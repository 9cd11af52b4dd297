#pragma once

#include <vector>

#include "measure/bench/bench_subject.hpp"

namespace manifuzz {

/// What this repository offers, the kernels once for every instruction set of this machine; and
/// the one-point answer of the separating axis alone, which is the cheapest that is right in depth.
/// Beside the kernels, their limits.
std::vector<BenchSubject> own_subjects();

}  // namespace manifuzz
