#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/random.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A family of cases with one knob, turned from benign to absurd while all else stays benign.
struct Sweep {
  std::string_view name;
  std::string_view description;  ///< one line for `list sweeps`
  std::string_view knob;         ///< what is turned, in words
  std::string_view unit;
  std::vector<double> values;  ///< 20 or more, from benign to absurd
  /// One attempt at a touching or nearly touching pair: none where floats leave no such pair.
  std::optional<PairCase> (*attempt)(Random& random, double knob);
};

/// Every sweep, in the order of `list sweeps`.
std::span<const Sweep> sweeps();

/// The sweep of that name, or nullptr.
const Sweep* find_sweep(std::string_view name);

/// Case `index` of a sweep with its knob at `value`: a function of (seed, the sweep's name, value,
/// index) alone.
PairCase draw_case(std::uint64_t seed, const Sweep& sweep, double value, std::uint64_t index);

/// The mantissas times 10^from, then times the next power, up to 10^to: each the double nearest to
/// the decimal.
std::vector<double> rising(std::initializer_list<int> mantissas, int from, int to);

/// The tenths times 10^from, then times the next power below, down to 10^to.
std::vector<double> falling(std::initializer_list<int> tenths, int from, int to);

/// 2^from, ..., 2, 1, 0.
std::vector<double> powers_of_two_to_zero(int from);

}  // namespace manifuzz
