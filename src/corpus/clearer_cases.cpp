#include "corpus/clearer_cases.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "corpus/shrink.hpp"
#include "generating/drafts.hpp"

namespace manifuzz {
namespace {

using MaybeCase = std::optional<PairCase>;

/// `number` with its digits, its point moved so that its first digit stands in this decimal place.
float with_exponent(float number, int exponent) {
  const int digits = significant_digits(number);
  double moved = number;
  for (int i = decimal_exponent(number); i != exponent; i += i < exponent ? 1 : -1) {
    moved = i < exponent ? moved * 10 : moved / 10;
  }
  return rounded_to_digits(static_cast<float>(moved), digits);
}

constexpr int kOrdinaryExponent = 3;  // 1e-3 to 1e3 are numbers of ordinary size

/// The decimal place of an ordinary number that is nearest to this one.
int nearest_ordinary(int exponent) {
  return std::clamp(exponent, -kOrdinaryExponent, kOrdinaryExponent - 1);
}

/// All numbers' decimal places divided by 2, 3 or 4 and brought to ordinary ones, or not divided.
void bring_all(const std::vector<float*>& numbers, int divisor) {
  for (float* const number : numbers) {
    if (*number == 0 || (divisor == 1 && is_ordinary(*number))) continue;
    const int exponent = decimal_exponent(*number) / divisor;
    *number = with_exponent(*number, nearest_ordinary(exponent));
  }
}

}  // namespace

rc::Seq<PairCase> with_ordinary_numbers(const PairCase& pair) {
  PairCase copy = pair;
  const std::vector<float*> numbers = free_numbers(copy);
  if (std::ranges::all_of(numbers, [](const float* x) { return is_ordinary(*x); })) return {};
  constexpr std::array kDivisors{2, 3, 4, 1};
  constexpr int kOfAll = kDivisors.size();
  constexpr int kPlaces = 2 * kOrdinaryExponent;
  const int count = kOfAll + static_cast<int>(numbers.size()) * kPlaces;
  return each_case(count, [pair, kDivisors](int i) -> MaybeCase {
    PairCase changed = pair;
    const std::vector<float*> all = free_numbers(changed);
    if (i < kOfAll) {
      bring_all(all, kDivisors[static_cast<std::size_t>(i)]);
      return changed;
    }
    float& number = *all[static_cast<std::size_t>((i - kOfAll) / kPlaces)];
    if (is_ordinary(number)) return std::nullopt;
    number = with_exponent(number, (i - kOfAll) % kPlaces - kOrdinaryExponent);
    return changed;
  });
}

rc::Seq<PairCase> with_a_clearer_lead(const PairCase& pair) {
  if (!complexity(pair).is_near_tie) return {};
  PairCase copy = pair;
  const int numbers = static_cast<int>(free_numbers(copy).size());
  constexpr std::array kFactors{2.0F, 0.5F, 1.5F};
  constexpr std::array kSteps{0.1F, -0.1F, 0.5F, -0.5F, 1.0F, -1.0F};
  constexpr int kChanges = kFactors.size() + kSteps.size();
  return each_case(numbers * kChanges, [pair, kFactors, kSteps](int i) -> MaybeCase {
    PairCase changed = pair;
    float& number = *free_numbers(changed)[static_cast<std::size_t>(i / kChanges)];
    const auto change = static_cast<std::size_t>(i % kChanges);
    if (change < kFactors.size()) {
      number = rounded_to_digits(number * kFactors[change], 2);
    } else {
      number = rounded_to_digits(number + kSteps[change - kFactors.size()], 2);
    }
    return changed;
  });
}

}  // namespace manifuzz
