#include "corpus/shrink.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "corpus/shrink_gate.hpp"
#include "exact/placed.hpp"
#include "generating/drafts.hpp"

namespace manifuzz {
namespace {

/// A float in scientific notation, as d.dddde+XX.
class Scientific {
 public:
  /// The shortest that reads back.
  explicit Scientific(float value)
      : end_(std::to_chars(text_.begin(), text_.end(), value, std::chars_format::scientific).ptr) {}
  Scientific(float value, int digits)
      : end_(std::to_chars(text_.begin(), text_.end(), value, std::chars_format::scientific,
                           digits - 1)
                 .ptr) {}

  int digits() const {
    return static_cast<int>(
        std::count_if(text_.data(), exponent_mark(), [](char c) { return c >= '0' && c <= '9'; }));
  }
  int exponent() const {
    int exponent = 0;
    const char* sign = exponent_mark() + 1;  // from_chars takes no plus
    std::from_chars(*sign == '+' ? sign + 1 : sign, end_, exponent);
    return exponent;
  }
  float value() const {
    double value = 0;
    std::from_chars(text_.data(), end_, value);
    return static_cast<float>(value);
  }

 private:
  const char* exponent_mark() const {
    return std::find(text_.data(), static_cast<const char*>(end_), 'e');
  }

  std::array<char, 32> text_{};
  char* end_;
};

}  // namespace

int significant_digits(float value) {
  return value == 0 ? 0 : Scientific(value).digits();
}

int decimal_exponent(float value) {
  return Scientific(value).exponent();
}

float rounded_to_digits(float value, int digits) {
  return Scientific(value, digits).value();
}

float nearer_to_zero(float value) {
  const Scientific written(value);
  float unit = 1;
  for (int e = written.exponent() - written.digits() + 1; e != 0; e += e < 0 ? 1 : -1) {
    unit = e < 0 ? unit / 10 : unit * 10;
  }
  return rounded_to_digits(value - std::copysign(unit, value), written.digits());
}

bool is_ordinary(float number) {
  const float magnitude = std::abs(number);
  return magnitude == 0 || (magnitude >= 1e-3F && magnitude <= 1e3F);
}

double lead_of_best_face(const PairCase& pair) {
  const exact::Separations separations = exact::separations(pair);
  constexpr double none = -std::numeric_limits<double>::infinity();
  double best = none;
  double second = none;
  for (const Side side : {Side::a, Side::b}) {
    for (int face = 0; face < pair[side].polygon.face_count(); ++face) {
      const double separation = separations.of_face[static_cast<std::size_t>(side)][face];
      second = std::max(second, std::min(best, separation));
      best = std::max(best, separation);
    }
  }
  if (second == none) return 1;
  const double lead = best - second;
  // What is less than the separations' own error is a tie.
  return lead > 2 * separations.error ? lead / size(pair) : 0;
}

namespace {

constexpr double kClearLead = 0.05;     // of the size
constexpr double kVisibleLead = 0.001;  // a lead below it is taken for a tie by who looks at it

void add_lead(const PairCase& pair, Complexity& result) {
  const double lead = lead_of_best_face(pair);
  result.is_near_tie = lead > 0 && lead < kVisibleLead;
  result.unclearness = lead >= kClearLead ? 0 : lead >= kVisibleLead ? 1 : 2;
}

}  // namespace

Complexity complexity(const PairCase& pair) {
  Complexity result;
  add_lead(pair, result);
  PairCase copy = pair;
  for (const float* number : free_numbers(copy)) {
    result.digits += significant_digits(*number);
    if (!is_ordinary(*number)) ++result.odd_numbers;
    const double magnitude = std::abs(static_cast<double>(*number));
    if (magnitude > 0) result.size += std::max(magnitude, 1 / magnitude);
    result.numbers.emplace_back(std::abs(*number), std::signbit(*number));
  }
  for (const Side side : {Side::a, Side::b}) {
    const Body& body = pair[side];
    result.vertices += body.polygon.count;
    if (!body.pose.position.isZero(0)) ++result.placements;
    if (body.polygon.radius != 0) ++result.placements;
    if (body.polygon.count >= kMinVertices && body.polygon.is_round()) ++result.placements;
    if (body.pose.rotation == Vector2<float>(1, 0)) continue;
    ++result.placements;
    if (body.pose.rotation.x() < 0) result.size += 1;
    for (const float number : body.pose.rotation) {
      result.digits += significant_digits(number);
      if (!is_ordinary(number)) ++result.odd_numbers;
      result.numbers.emplace_back(std::abs(number), std::signbit(number));
    }
  }
  return result;
}

std::vector<float> numbers_of(PairCase pair) {
  std::vector<float> numbers{static_cast<float>(pair.a.polygon.count),
                             pair.a.polygon.is_round() ? 1.0F : 0.0F,
                             pair.b.polygon.is_round() ? 1.0F : 0.0F};
  for (const float* number : free_numbers(pair)) numbers.push_back(*number);
  for (const Body* body : {&pair.a, &pair.b}) {
    numbers.insert(numbers.end(), body->pose.rotation.begin(), body->pose.rotation.end());
  }
  return numbers;
}

Shrunk shrink(const PairCase& pair, const std::function<bool(const PairCase&)>& still_fails,
              int evaluations_max) {
  ShrinkGate<PairCase> gate{still_fails, evaluations_max, {numbers_of(pair)}};
  const PairCase positive_zeros = without_negative_zeros(pair);
  const PairCase& start = gate.fails(positive_zeros) ? positive_zeros : pair;
  // A lambda, since clang cannot bind a plain function here.
  const auto simpler = [](const PairCase& parent) { return simpler_cases(parent); };
  return {smallest(start, simpler, gate), gate.evaluations, gate.complete};
}

}  // namespace manifuzz
