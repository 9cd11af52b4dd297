#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "measure/bench/bench_subject.hpp"
#include "measure/spread.hpp"

namespace manifuzz {

/// What a collider is off by, as the referee measures it.
struct BenchErrors {
  ErrorSpreads of_extent;  ///< of all contacts, in units of 2^-24 of the extent; normals of 2^-24
  std::map<std::uint64_t, PairCase> worst;  ///< the spreads' worst cases, by their indices
  std::uint64_t missed = 0;
  std::uint64_t phantom = 0;
  std::uint64_t cases = 0;  ///< answered
};

/// Of the subjects that give manifolds, by name: however it is asked, a collider answers alike.
std::map<std::string, BenchErrors> measure_errors(const std::vector<BenchSubject>& subjects,
                                                  std::span<const PairCase> pairs);

}  // namespace manifuzz
