#pragma once

#include <vector>

#include "measure/bench/bench_subject.hpp"

namespace manifuzz {

/// Everything that `bench` times, Box2D first.
std::vector<BenchSubject> bench_subjects();

}  // namespace manifuzz
