#pragma once

#include <vector>

#include "measure/bench/bench_subject.hpp"

namespace manifuzz {

/// What no kernel can beat, timed beside them, for one instruction set: the arithmetic of the pairs
/// in full lanes, all of it independent, and the bytes of packed pairs and their manifolds, read
/// and written once.
std::vector<BenchSubject> limits(const std::string& target);

/// Additions, subtractions, multiplications, quotients and comparisons that the manifold of a pair
/// takes, from poses to depths; `touches` says whether there is anything to clip.
int operations(int count_a, int count_b, bool touches);

}  // namespace manifuzz
