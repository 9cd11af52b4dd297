#include <cmath>
#include <vector>

#include "generating/drafts.hpp"
#include "hunting/moves.hpp"

namespace manifuzz {
namespace {

/// Any number of the case but rotations, which are moved as such.
float& any_number(Random& random, PairCase& pair) {
  const std::vector<float*> numbers = free_numbers(pair);
  return *numbers[static_cast<std::size_t>(
      random.integer(0, static_cast<int>(numbers.size()) - 1))];
}

float signed_power_of_two(Random& random, int low, int high) {
  return static_cast<float>(random.either_sign(power_of_two(random.integer(low, high))));
}

/// By 1 ulp to 2^22 of them, which is up to a half.
void step(Random& random, PairCase& pair, const PairCase&) {
  float& number = any_number(random, pair);
  const int most = 1 << random.integer(0, 22);
  const int steps = random.integer(1, most);
  number = stepped(number, random.chance(0.5) ? steps : -steps);
}

/// By a share of itself, 2^-23 to a half.
void change_by_a_share(Random& random, PairCase& pair, const PairCase&) {
  float& number = any_number(random, pair);
  number *= 1 + signed_power_of_two(random, -23, -1);
}

void set_equal_to_another(Random& random, PairCase& pair, const PairCase&) {
  const float other = any_number(random, pair);
  any_number(random, pair) = random.chance(0.75) ? other : -other;
}

/// One coordinate to a share beside another: equal but for a difference of 2^-22 to 2^-4 of it.
void set_close_to_another(Random& random, PairCase& pair, const PairCase&) {
  const float other = any_number(random, pair);
  any_number(random, pair) = other * (1 + signed_power_of_two(random, -22, -4));
}

void set_to_zero(Random& random, PairCase& pair, const PairCase&) {
  any_number(random, pair) = 0;
}

/// To the power of two next below it, mostly, else to any.
void set_to_a_power_of_two(Random& random, PairCase& pair, const PairCase&) {
  float& number = any_number(random, pair);
  if (number == 0 || random.chance(0.25)) {
    number = signed_power_of_two(random, -10, 10);
  } else {
    number = std::copysign(static_cast<float>(power_of_two(std::ilogb(number))), number);
  }
}

void double_or_halve(Random& random, PairCase& pair, const PairCase&) {
  any_number(random, pair) *= random.chance(0.5) ? 2.0F : 0.5F;
}

void turn_sign(Random& random, PairCase& pair, const PairCase&) {
  float& number = any_number(random, pair);
  number = -number;
}

/// All lengths by up to 2 or down to 1/2: how much of a bound rounding takes depends on where
/// between two powers of two they lie.
void scale_within_an_octave(Random& random, PairCase& pair, const PairCase&) {
  scale_lengths(pair, static_cast<float>(random.magnitude(-1, 1)));
}

constexpr Move kMovesOfNumbers[] = {
    {"step", step},
    {"share", change_by_a_share},
    {"equal", set_equal_to_another},
    {"close", set_close_to_another},
    {"zero", set_to_zero},
    {"power_of_two", set_to_a_power_of_two},
    {"double", double_or_halve},
    {"sign", turn_sign},
    {"octave", scale_within_an_octave},
};

}  // namespace

std::span<const Move> moves_of_numbers() {
  return kMovesOfNumbers;
}

}  // namespace manifuzz
