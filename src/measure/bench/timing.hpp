#pragma once

#include <vector>

#include "measure/bench/bench_subject.hpp"
#include "measure/bench/workload.hpp"

namespace manifuzz {

struct TimingOptions {
  int repetitions = 9;
  double repetition_seconds = 0.02;
};

struct Timing {
  double ns_per_pair = 0;         ///< the median of the repetitions
  double speedup_over_box2d = 0;  ///< the median of their ratios, each to Box2D's of its number
};

/// Times the subjects over one workload, on Google Benchmark, their repetitions in random order;
/// the kernels then use the widest instruction set again.
std::vector<Timing> time_subjects(const std::vector<BenchSubject>& subjects,
                                  const Workload& workload, const TimingOptions& options);

}  // namespace manifuzz
