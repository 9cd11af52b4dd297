#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "campaign/tally.hpp"
#include "collider/collider.hpp"
#include "generating/regime.hpp"

namespace manifuzz {

inline constexpr std::uint64_t kJudgeEvery = 256;

/// What a campaign runs: which cases, through which two colliders.
struct Plan {
  Collider subject;
  Collider oracle;
  std::vector<const Regime*> regimes;  ///< not empty, at most kRegimesMax
  GenerationContext context;
  bool is_narrowed =
      false;  ///< the context's radius is what the colliders take, not what was asked
  std::uint64_t seed = 0;
  std::uint64_t first = 0;             ///< index in each regime of its first case
  std::optional<std::uint64_t> cases;  ///< of all regimes together; none: until time is up
  std::optional<double> seconds;
  bool until_new = false;  ///< it ends where a bucket is found that its corpus does not show
  int jobs = 1;
  /// Two colliders can be wrong alike: of the cases on which they plainly agree, one in so many is
  /// judged all the same.
  std::uint64_t judge_every = kJudgeEvery;

  /// How many cases there are to run, up to the last index where time alone ends the campaign.
  CaseNumber cases_max() const {
    constexpr CaseNumber most = std::numeric_limits<CaseNumber>::max();
    const CaseNumber indices = most - first;
    return cases.value_or(indices < most / regimes.size() ? indices * regimes.size() : most);
  }
  std::size_t regime_of(CaseNumber number) const { return number % regimes.size(); }
  std::uint64_t index_of(CaseNumber number) const { return first + number / regimes.size(); }
  PairCase pair(CaseNumber number) const {
    return generate(seed, *regimes[regime_of(number)], index_of(number), context);
  }
};

/// Takes the radii away where a collider takes none.
inline void narrow_to_colliders(Plan& plan) {
  plan.is_narrowed =
      !plan.subject.declaration.takes_radius || !plan.oracle.declaration.takes_radius;
  if (plan.is_narrowed) plan.context.radius = 0.0F;
}

}  // namespace manifuzz
