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

double AnswerError::total() const {
  return std::accumulate(errors.all().begin(), errors.all().end(), 0.0);  // in order
}

bool is_less_wrong(const AnswerError& first, const AnswerError& second) {
  // Beside a figure that is beyond all others their sum tells nothing.
  const auto beside_greatest = [](AnswerError of) {
    if (of.component) of.errors[*of.component] = 0;
    return of.total();
  };
  return std::pair(first.total(), beside_greatest(first)) <
         std::pair(second.total(), beside_greatest(second));
}

}  // namespace manifuzz
