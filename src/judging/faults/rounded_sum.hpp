#pragma once

namespace manifuzz::ledger_of {

/// What a sum of two loses by rounding.
inline double lost_in(double a, double b, double sum) {
  const double share_of_b = sum - a;
  return a - (sum - share_of_b) + (b - share_of_b);
}

/// The sum of three, rounded once, as scripts/colliders/protocol.mjs adds them: sumOf.
inline double sum_rounded_once(double a, double b, double c) {
  const double first = a + b;
  const double sum = first + c;
  return sum + (lost_in(a, b, first) + lost_in(first, c, sum));
}

}  // namespace manifuzz::ledger_of
