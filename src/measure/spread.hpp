#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "judging/manifold_error.hpp"
#include "measure/referee.hpp"

namespace manifuzz {

/// How one error is spread over many contacts: each figure is one of the values, the nearest rank,
/// none lies between two. All 0 where there is no contact.
struct Spread {
  double median = 0;
  double p999 = 0;  ///< the 99.9th percentile
  double max = 0;
  std::uint64_t worst = 0;  ///< the case of the largest, the first of equals

  friend bool operator==(const Spread&, const Spread&) = default;
};

struct ErrorSpreads {
  Spread depth;
  Spread position;
  Spread normal;

  friend bool operator==(const ErrorSpreads&, const ErrorSpreads&) = default;
};

/// The upper one of two; not of nothing.
double median(std::vector<double> values);

/// To float; what is beyond it, or no number, is the largest float.
float to_float(double value);

/// `cases`: the case of each value.
Spread spread_of(std::vector<float> values, std::span<const std::uint64_t> cases);

/// The errors of many contacts, kept as floats for there are many.
class ErrorList {
 public:
  void add(std::uint64_t index, const ManifoldError& error);
  ErrorSpreads spreads() const;
  std::span<const std::uint64_t> cases() const { return cases_; }  ///< of each, as it was added

 private:
  std::vector<std::uint64_t> cases_;
  std::vector<float> depth_;
  std::vector<float> position_;
  std::vector<float> normal_;
};

/// ",MEDIAN,P999,MAX".
std::string spread_csv(const Spread& spread);

/// {"median", "p999", "max"}.
nlohmann::ordered_json spread_json(const Spread& spread);

/// {"depth", "position", "normal"}, each a spread, to which `add_worst` may add its worst case.
nlohmann::ordered_json spreads_json(
    const ErrorSpreads& spreads,
    const std::function<void(nlohmann::ordered_json& json, const Spread& spread)>& add_worst = {});

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
