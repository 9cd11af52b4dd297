#pragma once

#include <cstdint>
#include <vector>

#include "measure/referee.hpp"
#include "measure/spread.hpp"

namespace manifuzz {

/// One collider over many cases: how often it was assessed as what, and its errors.
struct ErrorStatistics {
  std::uint64_t cases = 0;
  std::uint64_t unsupported = 0;
  std::uint64_t ill_posed = 0;
  std::uint64_t contacts = 0;  ///< with points that were measured
  std::uint64_t missed = 0;
  std::uint64_t phantom = 0;
  std::uint64_t wrong_count = 0;
  std::uint64_t gross = 0;
  std::uint64_t lost = 0;
  ErrorSpreads of_size;  ///< `Measured` says in what units
  ErrorSpreads of_bound;
  Spread of_extent;
  std::uint64_t worst_wrong = 0;  ///< the case of the wrong answer that is farthest off
  float wrongness = 0;            ///< how far, as a share of the size

  std::uint64_t well_posed() const { return cases - unsupported - ill_posed; }
  std::uint64_t wrong() const { return missed + phantom + wrong_count + gross + lost; }

  friend bool operator==(const ErrorStatistics&, const ErrorStatistics&) = default;
};

/// Collects what a collider is measured by, case by case.
class ErrorCollector {
 public:
  enum class Errors { kept, counted };  ///< counted alone: no spreads, and no memory for them
  explicit ErrorCollector(Errors errors = Errors::kept) : errors_(errors) {}

  void add(std::uint64_t index, const Measured& measured);
  ErrorStatistics statistics() const;

 private:
  Errors errors_;
  ErrorStatistics counts_;
  ErrorList of_size_;
  ErrorList of_bound_;
  std::vector<float> of_extent_;
};

}  // namespace manifuzz
