#include "corpus/shrink.hpp"

#include <set>
#include <vector>

#include <rapidcheck.h>

#include "corpus/simpler_cases.hpp"
#include "generating/edits.hpp"

namespace manifuzz {
namespace {

/// All that tells two cases apart.
std::vector<float> numbers_of(PairCase pair) {
  std::vector<float> numbers{static_cast<float>(pair.a.polygon.count)};
  for (const float* number : free_numbers(pair)) numbers.push_back(*number);
  for (const Side side : {Side::a, Side::b}) {
    numbers.push_back(pair[side].pose.rotation.x());
    numbers.push_back(pair[side].pose.rotation.y());
  }
  return numbers;
}

}  // namespace

Shrunk shrink(const PairCase& pair, const std::function<bool(const PairCase&)>& still_fails,
              int evaluations_max) {
  Shrunk result;
  std::set<std::vector<float>> seen{numbers_of(pair)};
  const auto consider = [&](const PairCase& candidate) {
    if (!result.complete || !seen.insert(numbers_of(candidate)).second) return false;
    if (result.evaluations == evaluations_max) {
      result.complete = false;
      return false;
    }
    ++result.evaluations;
    return still_fails(candidate);
  };
  const PairCase positive_zeros = without_negative_zeros(pair);
  ++result.evaluations;
  const PairCase& start = still_fails(positive_zeros) ? positive_zeros : pair;
  // A lambda, since clang cannot bind a plain function here.
  const auto simpler = [](const PairCase& parent) { return simpler_cases(parent); };
  const auto tree = rc::shrinkable::shrinkRecur(start, simpler);
  result.pair = rc::shrinkable::findLocalMin(tree, consider).first;
  return result;
}

}  // namespace manifuzz
