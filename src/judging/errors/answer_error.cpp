#include "judging/errors/answer_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace manifuzz {

void widen(Errors& worst, const Errors& other) {
  for (std::size_t i = 0; i < kComponentNames.size(); ++i) {
    worst.all()[i] = std::max(worst.all()[i], other.all()[i]);
  }
}

void widen(WorstError& worst, const WorstError& other) {
  worst.magnitude = std::max(worst.magnitude, other.magnitude);
  widen(worst.errors, other.errors);
}

void AnswerError::add(Component of, double error, double within) {
  if (!(error <= within)) add_beyond(of, error, within);
}

void AnswerError::add_beyond(Component of, double error, double within) {
  // A difference of infinities is no number, and no small error.
  if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
  error = std::max(error, within);
  errors[of] = std::max(errors[of], error);
  if (component && error <= magnitude) return;
  magnitude = error;
  bound = within;
  component = of;
}

bool is_less_wrong(const AnswerError& first, const AnswerError& second) {
  const auto sum = [](const AnswerError& of) {
    return std::accumulate(of.errors.all().begin(), of.errors.all().end(), 0.0);  // in order
  };
  return std::pair(first.magnitude, sum(first)) < std::pair(second.magnitude, sum(second));
}

}  // namespace manifuzz
