#pragma once

#include <compare>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// How hard a case is to read, the weightiest first: the order of shrinking.
struct Complexity {
  int vertices = 0;    ///< of both polygons
  int placements = 0;  ///< positions, rotations and radii that are not zero or the identity
  int digits = 0;      ///< significant decimal digits of all numbers, 0 has none
  double size = 0;     ///< sum of max(|x|, 1/|x|): large numbers and tiny ones are hard to read
  /// |x| and its sign of every number in turn, so that of symmetric images one is the simplest.
  std::vector<std::pair<float, bool>> numbers;

  friend auto operator<=>(const Complexity&, const Complexity&) = default;
};

Complexity complexity(const PairCase& pair);

/// The significant decimal digits of the shortest decimal that reads back as `value`.
int significant_digits(float value);

/// `value` to at most `digits` significant decimal digits.
float rounded_to_digits(float value, int digits);

/// `value` with its last significant digit one nearer to zero: 7 to 6, -0.25 to -0.24.
float nearer_to_zero(float value);

}  // namespace manifuzz
