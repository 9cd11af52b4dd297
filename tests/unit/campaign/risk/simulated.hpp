#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "campaign/risk/unseen.hpp"

namespace manifuzz::test {

/// How likely a case of the row is to show each bucket: by always being judged, and as an agreed
/// contact, which shows it only where it is judged. What is left shows none.
struct Law {
  std::string name;
  std::vector<double> always;
  std::vector<double> agreed{};  ///< none, or as many
  double agreed_share = 0;       ///< of all cases
};

/// Counts 0 to 3 of a Poisson number; 3 stands for any more.
class FewOfPoisson {
 public:
  explicit FewOfPoisson(double mean) {
    double term = std::exp(-mean);
    for (int k = 1; k <= 3; ++k) {
      up_to_[k - 1] = (k == 1 ? 0 : up_to_[k - 2]) + term;
      term *= mean / k;
    }
  }
  unsigned draw(Random& random) const {
    const double u = random.unit();
    return u < up_to_[0] ? 0 : u < up_to_[1] ? 1 : u < up_to_[2] ? 2 : 3;
  }

 private:
  std::array<double, 3> up_to_{};
};

/// A row's campaign of a law, as a Poisson number of cases gives it, so that buckets do not depend
/// on each other. It may go on for as many cases again.
class SimulatedRow {
 public:
  SimulatedRow(const Law& law, double cases, double judge_every)
      : law_(law), cases_(cases), judge_every_(judge_every), met_(law.always.size()) {
    for (const double chance : law.always) draws_of_always_.emplace_back(cases * chance);
    for (const double chance : law.agreed) {
      draws_of_agreed_.emplace_back(cases * chance / judge_every);
    }
  }

  void clear() {
    for (auto& met : met_) met = {};
    times_ = 0;
  }

  /// So many cases more.
  void run(Random& random) {
    ++times_;
    for (std::size_t i = 0; i < met_.size(); ++i) {
      met_[i][0] += draws_of_always_[i].draw(random);
      if (!draws_of_agreed_.empty()) met_[i][1] += draws_of_agreed_[i].draw(random);
    }
  }

  std::array<Stratum, 2> strata() const {
    const double cases = times_ * cases_;
    const auto agreed = static_cast<std::uint64_t>(std::round(cases * law_.agreed_share));
    const auto judged =
        static_cast<std::uint64_t>(std::round(cases * law_.agreed_share / judge_every_));
    const auto always = static_cast<std::uint64_t>(std::round(cases)) - agreed;
    std::array<Stratum, 2> strata{{{always, always}, {agreed, judged}}};
    for (const auto& [by_always, by_agreed] : met_) {
      if (by_always + by_agreed == 1) ++strata[by_agreed].once;
      if (by_always + by_agreed == 2 && by_agreed != 1) ++strata[by_agreed / 2].twice;
    }
    return strata;
  }

  /// The chance that the next case shows, or would show, a bucket that none has shown.
  double unseen() const {
    double sum = 0;
    for (std::size_t i = 0; i < met_.size(); ++i) {
      if (met_[i][0] + met_[i][1] > 0) continue;
      sum += law_.always[i] + (law_.agreed.empty() ? 0 : law_.agreed[i]);
    }
    return sum;
  }

 private:
  const Law& law_;
  double cases_;
  double judge_every_;
  double times_ = 0;
  std::vector<FewOfPoisson> draws_of_always_{};
  std::vector<FewOfPoisson> draws_of_agreed_{};
  std::vector<std::array<unsigned, 2>> met_;
};

/// So many buckets of weights that `weight_of` gives, together of this chance.
template <class WeightOf>
std::vector<double> chances(int buckets, double together, const WeightOf& weight_of) {
  std::vector<double> all;
  double sum = 0;
  for (int i = 0; i < buckets; ++i) sum += all.emplace_back(weight_of(i));
  for (double& chance : all) chance *= together / sum;
  return all;
}

/// Alike, by powers of the rank, halved from one to the next, a few common ones above a long tail,
/// over all magnitudes.
inline std::vector<Law> known_laws() {
  const auto alike = [](int) { return 1.0; };
  const auto by_power = [](double power) {
    return [power](int i) { return std::pow(i + 1, -power); };
  };
  const auto by_ratio = [](double ratio) { return [ratio](int i) { return std::pow(ratio, i); }; };
  const auto tailed = [](int i) { return i < 3 ? 1000.0 : std::pow(i, -0.5); };
  Random random(1, "magnitudes", 0);
  const auto spread = [&random](int) { return random.magnitude(-30, 0); };
  return {{"100 alike", chances(100, 0.3, alike)},
          {"1000 alike", chances(1000, 1, alike)},
          {"by rank", chances(500, 0.3, by_power(1))},
          {"by rank squared", chances(300, 0.3, by_power(2))},
          {"by half", chances(40, 0.3, by_ratio(0.5))},
          {"by a tenth less", chances(200, 0.3, by_ratio(0.9))},
          {"a long tail", chances(400, 0.3, tailed)},
          {"all magnitudes", chances(300, 0.3, spread)}};
}

}  // namespace manifuzz::test
