#pragma once

#include <compare>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// How hard a case is to read and to believe, the weightiest first: the order of shrinking.
struct Complexity {
  int vertices = 0;     ///< of both polygons
  int placements = 0;   ///< positions, rotations, radii that are not zero, polygons' round corners
  int odd_numbers = 0;  ///< of magnitude outside 1e-3 to 1e3, but for 0
  bool is_near_tie = false;  ///< the best two faces are nearly, and not quite, as good
  int digits = 0;            ///< significant decimal digits of all numbers, 0 has none
  int unclearness = 0;       ///< how little the best face leads, in steps: 0 is a clear lead
  double size = 0;  ///< sum of max(|x|, 1/|x|): large numbers and tiny ones are hard to read
  /// |x| and its sign of every number in turn, so that of symmetric images one is the simplest.
  std::vector<std::pair<float, bool>> numbers;

  friend auto operator<=>(const Complexity&, const Complexity&) = default;
};

Complexity complexity(const PairCase& pair);

/// What of it tells how simple a case is: of cases as simple as each other the one that shows the
/// greater error is preferred, and then the rest decides.
inline auto simplicity(const Complexity& of) {
  return std::tuple(of.vertices, of.placements, of.odd_numbers, of.is_near_tie, of.digits,
                    of.unclearness);
}

/// Whether a number has an ordinary size, which one can picture, or is 0.
bool is_ordinary(float number);

/// By how much the separation of the best face leads over that of the second best one, as a share
/// of the size; 1 where there are no two faces.
double lead_of_best_face(const PairCase& pair);

/// The significant decimal digits of the shortest decimal that reads back as `value`.
int significant_digits(float value);

/// The power of ten of its first significant digit. Not of 0.
int decimal_exponent(float value);

/// `value` to at most `digits` significant decimal digits.
float rounded_to_digits(float value, int digits);

/// `value` with its last significant digit one nearer to zero: 7 to 6, -0.25 to -0.24.
float nearer_to_zero(float value);

/// Every simpler case next to this one, the boldest first: the plainest cases there are, then
/// without a vertex, with identity poses and mitred corners, with fewer digits, with smaller
/// numbers, and the symmetric image that is simplest. All valid, all of less `complexity`. Lazy.
rc::Seq<PairCase> simpler_cases(const PairCase& pair);

/// Changes that are alike, and in one order, for all cases with the same shapes, simpler or not,
/// valid or not: for cases that are changed together. Lazy.
rc::Seq<PairCase> like_changes(const PairCase& pair);

/// The simpler cases among these, and those with one number simpler. Lazy.
rc::Seq<PairCase> simpler_neighbours(const PairCase& pair);

/// The case with 0 in place of -0: as simple cases have it.
PairCase without_negative_zeros(PairCase pair);

/// All that tells two cases apart.
std::vector<float> numbers_of(PairCase pair);

struct Shrunk {
  PairCase pair;
  int evaluations = 0;   ///< how often the predicate ran
  bool complete = true;  ///< false where the limit came before the minimum
};

inline constexpr int kShrinkEvaluations = 20'000;

/// The smallest case that `still_fails`, by steps from `pair` to one of its `simpler_cases` that
/// still fails too; `pair` itself at worst. No case is tried twice. Deterministic.
Shrunk shrink(const PairCase& pair, const std::function<bool(const PairCase&)>& still_fails,
              int evaluations_max = kShrinkEvaluations);

}  // namespace manifuzz
