#include "generating/sweep.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "generating/sweep_list.hpp"

namespace manifuzz {
namespace {

/// As far from unit as a valid rotation may be.
const std::vector<double> kOffUnitValues{1e-7, 1.2e-7, 1.5e-7, 2e-7,   2.5e-7, 3e-7,   4e-7,  5e-7,
                                         6e-7, 8e-7,   1e-6,   1.2e-6, 2e-6,   2.5e-6, 3e-6,  4e-6,
                                         5e-6, 6e-6,   7e-6,   8e-6,   9e-6,   9.5e-6, 9.8e-6};

double power_of_ten(int exponent) {
  double power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;  // exact up to 10^22
}

double decimal(int mantissa, int exponent) {
  return exponent >= 0 ? mantissa * power_of_ten(exponent) : mantissa / power_of_ten(-exponent);
}

}  // namespace

std::span<const Sweep> sweeps() {
  static const std::vector<Sweep> all = {
#define MANIFUZZ_ENTRY(name, knob, unit, values, description) \
  {#name, description, knob, unit, values, turn::name},
      MANIFUZZ_SWEEPS(MANIFUZZ_ENTRY)
#undef MANIFUZZ_ENTRY
  };
  return all;
}

const Sweep* find_sweep(std::string_view name) {
  const auto found = std::ranges::find(sweeps(), name, &Sweep::name);
  return found == sweeps().end() ? nullptr : &*found;
}

PairCase draw_case(std::uint64_t seed, const Sweep& sweep, double value, std::uint64_t index) {
  constexpr int attempts = 1000;
  Random random(mix(seed) ^ std::bit_cast<std::uint64_t>(value), sweep.name, index);
  for (int i = 0; i < attempts; ++i) {
    if (const auto pair = sweep.attempt(random, value)) return *pair;
  }
  throw std::logic_error(fmt::format("sweep {} draws nothing at {}", sweep.name, value));
}

std::vector<double> rising(std::initializer_list<int> mantissas, int from, int to) {
  std::vector<double> values;
  for (int exponent = from; exponent < to; ++exponent) {
    for (const int mantissa : mantissas) values.push_back(decimal(mantissa, exponent));
  }
  values.push_back(decimal(1, to));
  return values;
}

std::vector<double> falling(std::initializer_list<int> tenths, int from, int to) {
  std::vector<double> values;
  for (int exponent = from; exponent > to; --exponent) {
    for (const int tenth : tenths) values.push_back(decimal(tenth, exponent - 1));
  }
  values.push_back(decimal(1, to));
  return values;
}

std::vector<double> powers_of_two_to_zero(int from) {
  std::vector<double> values;
  for (int exponent = from; exponent >= 0; --exponent) values.push_back(std::ldexp(1.0, exponent));
  values.push_back(0);
  return values;
}

}  // namespace manifuzz
