#include "hunting/climb.hpp"

#include <algorithm>
#include <span>

#include "generating/regime.hpp"
#include "hunting/breeding.hpp"
#include "hunting/wrong_answers.hpp"
#include "judging/curve_answer.hpp"

namespace manifuzz::test {
namespace {

/// Cases are drawn to take parts of. A climb begins with the best of 1 to 256 of them: the best of
/// many lie on the same few slopes.
constexpr int kDrawn = 256;
/// A bound has the defect of rotations in it, and an error half of that at most: where a defect is
/// large nothing else is seen. One climb of three stays where it is no more than rounding leaves.
constexpr double kSmallDefect = 0x1p-22;
/// A share of moves that is of single numbers: from what is high, small steps alone lead higher.
constexpr double kOfNumbers = 0.7;

class Climber {
 public:
  Climber(const Summit& summit, const Collider& collider, std::span<const PairCase> founders,
          std::uint64_t seed, std::uint64_t index)
      : summit_(summit),
        collider_(collider),
        has_small_defects_(index % 3 == 1),
        random_(seed, summit.name, index) {
    draw(seed);
    const std::uint64_t of_its_way = index / 3;
    const auto founder =
        founders.begin() +
        static_cast<std::ptrdiff_t>(founders.empty() ? 0 : of_its_way % founders.size());
    here_.pair = drawn_.front();
    if (index % 3 == 2 && !founders.empty() && is_round(*founder) == summit.is_round) {
      step_to(*founder);
    } else {
      for (int i = 0; i < 1 << of_its_way % 9; ++i) step_to(drawn_[static_cast<std::size_t>(i)]);
    }
  }

  Climbed run(std::uint64_t cases) {
    for (std::uint64_t i = 0; i < cases; ++i) {
      const PairCase& mate = drawn_[static_cast<std::size_t>(random_.integer(0, kDrawn - 1))];
      const auto child = bred(random_, here_.pair, mate, {.of_numbers = kOfNumbers});
      if (child && is_round(*child) == summit_.is_round && is_in_use(*child)) step_to(*child);
    }
    return climbed_;
  }

 private:
  void draw(std::uint64_t seed) {
    const std::span<const Regime> regimes = summit_.is_round ? round_regimes() : polygon_regimes();
    const auto last = static_cast<int>(regimes.size()) - 1;
    for (int i = 0; i < kDrawn; ++i) {
      const Regime& regime = regimes[static_cast<std::size_t>(random_.integer(0, last))];
      drawn_.push_back(generate(seed, regime, random_.bits() >> 32));
    }
  }

  void step_to(const PairCase& pair) {
    const double share = share_at(pair);
    if (share >= here_.share) here_ = {share, pair};
  }

  /// The share of the summit's bound; 0 where the climb does not go, the answer is wrong, or says
  /// that they are apart.
  double share_at(const PairCase& pair) {
    if (has_small_defects_ &&
        std::max(rotation_defect(pair.a), rotation_defect(pair.b)) > kSmallDefect) {
      return 0;
    }
    const Answer answer = collider_.collide(pair);
    const exact::Truth truth(pair);
    const Bounds bounds = manifuzz::bounds(pair, collider_.declaration, truth.extent());
    if (is_ill_posed(truth.size_at_least(), bounds)) return 0;
    if (!touches(answer)) {
      const bool may_be_apart = truth.separation() > total_radius(pair) - 2 * bounds.separation;
      if (!may_be_apart) (void)is_wrong(pair);
      return 0;
    }
    return noted(pair, shares_observed(unowned(truth), {collider_.declaration, answer}));
  }

  /// The share of the summit's bound, once the highest of each bound are noted. What is no higher
  /// is not judged: held against clips, a wrong answer has no share.
  double noted(const PairCase& pair, const Observation& seen) {
    bool is_in_doubt = seen[summit_.gauge] == 0;
    for (std::size_t k = 0; k < kGauges; ++k) {
      is_in_doubt =
          is_in_doubt || seen.gauges[k] >= 1 || seen.gauges[k] > climbed_.highest[k].share;
    }
    if (!is_in_doubt) return seen[summit_.gauge];
    if (is_wrong(pair)) return 0;
    for (std::size_t k = 0; k < kGauges; ++k) {
      if (seen.gauges[k] > climbed_.highest[k].share) climbed_.highest[k] = {seen.gauges[k], pair};
    }
    return seen[summit_.gauge];
  }

  bool is_wrong(const PairCase& pair) {
    const bool is_wrong = wrong_answer(collider_, pair).has_value();
    if (is_wrong && !climbed_.wrong) climbed_.wrong = pair;
    return is_wrong;
  }

  const Summit& summit_;
  const Collider& collider_;
  bool has_small_defects_;
  Random random_;
  std::vector<PairCase> drawn_;
  Height here_;
  Climbed climbed_;
};

}  // namespace

std::vector<Summit> summits_of(const Declaration& declaration) {
  std::vector<Summit> summits{{"normal", Gauge::normal_share},
                              {"depth", Gauge::depth_share},
                              {"normal of round shapes", Gauge::normal_share, true},
                              {"depth of round shapes", Gauge::depth_share, true}};
  if (!is_judged_by_curve(declaration)) summits.push_back({"position", Gauge::position_share});
  return summits;
}

Climbed climb(const Summit& summit, const Collider& collider, std::span<const PairCase> founders,
              std::uint64_t seed, std::uint64_t index, std::uint64_t cases) {
  return Climber(summit, collider, founders, seed, index).run(cases);
}

}  // namespace manifuzz::test
