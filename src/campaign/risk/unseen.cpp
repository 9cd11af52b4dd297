#include "campaign/risk/unseen.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {
namespace {

// Sums, products and square roots alone: libraries' exponentials differ in their last bits.

/// e^-x, x at least 0.
double exp_of_minus(double x) {
  int halvings = 0;
  for (; x > 0.5; x /= 2) ++halvings;
  constexpr int kTerms = 16;  // 0.5^17 / 17! is below a rounding
  double sum = 1;
  for (int k = kTerms; k > 0; --k) sum = 1 - x / k * sum;
  for (; halvings > 0; --halvings) sum *= sum;
  return sum;
}

/// Where a decreasing function falls to `level`, between `from` and `to`.
template <class Function>
double where_falls_to(double level, double from, double to, const Function& function) {
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (from + to) / 2;
    (function(middle) > level ? from : to) = middle;
  }
  return to;
}

/// The chance that a standard normal number is above z, 0 to 8: the density times z + z^3 / 3 +
/// z^5 / (3 5) + ... is what lies between 0 and z.
double normal_above(double z) {
  constexpr double kRootOfTwoPi = 2.5066282746310002;
  double term = z;
  double sum = z;
  for (int k = 3; term > sum * 1e-17; k += 2) {
    term *= z * z / k;
    sum += term;
  }
  return 0.5 - sum * exp_of_minus(z * z / 2) / kRootOfTwoPi;
}

/// The chance that a Poisson number of this mean is at most `count`.
double poisson_at_most(std::uint64_t count, double mean) {
  constexpr double kStep = 300;
  const double small = exp_of_minus(kStep);
  double left = mean;  // of the exponent: e^-mean as one factor would be 0 from 746 on
  double term = 1;
  double sum = 1;
  for (std::uint64_t k = 1; k <= count; ++k) {
    term *= mean / static_cast<double>(k);
    sum += term;
    if (sum * small < 1 || left < kStep) continue;
    term *= small;
    sum *= small;
    left -= kStep;
  }
  return sum * exp_of_minus(left);
}

/// A count's mean, below which and above which it lies with the chance `tail`.
struct Means {
  double least = 0;
  double greatest = 0;
};
Means means_of(std::uint64_t count, double tail) {
  const auto met = static_cast<double>(count);
  const double beyond = met + 50 + 10 * std::sqrt(met);
  const double least = count == 0 ? 0 : where_falls_to(1 - tail, 0, met, [&](double mean) {
    return poisson_at_most(count - 1, mean);
  });
  return {least, where_falls_to(tail, met, beyond,
                                [&](double mean) { return poisson_at_most(count, mean); })};
}

Chance chance_in(const Stratum& of, double error) {
  if (of.judged == 0) return {};
  const auto once = static_cast<double>(of.once);
  const auto judged = static_cast<double>(of.judged);
  const double variance = once + 2 * static_cast<double>(of.twice) + 2;
  const double reach = where_falls_to(error / 2, 0, 8, normal_above) * std::sqrt(variance);
  const Means poisson = means_of(of.once, error / 2);
  return {once / judged, std::max(0.0, std::min(once - reach, poisson.least)) / judged,
          std::min(1.0, std::max(once + reach, poisson.greatest) / judged)};
}

}  // namespace

Chance chance_of_unseen(std::span<const Stratum> strata, double error) {
  const auto parts = std::ranges::count_if(strata, [](const Stratum& of) { return of.cases > 0; });
  std::uint64_t cases = 0;
  for (const Stratum& of : strata) cases += of.cases;
  if (cases == 0) return {};
  Chance sum{0, 0, 0};
  for (const Stratum& of : strata) {
    if (of.cases == 0) continue;
    const Chance part = chance_in(of, error / static_cast<double>(parts));
    const double share = static_cast<double>(of.cases) / static_cast<double>(cases);
    sum.next += share * part.next;
    sum.low += share * part.low;
    sum.high += share * part.high;
  }
  return sum;
}

}  // namespace manifuzz
