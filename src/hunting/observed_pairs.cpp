#include "hunting/observed_pairs.hpp"

#include <algorithm>

namespace manifuzz {

void ObservedPairs::learn(CaseNumber number, const JudgedPair& judged) const {
  note(number, observation_of(judged));
  if (on_judged_) on_judged_(number, judged);
}

void ObservedPairs::begin_part(SharedQueue::Block cases) {
  cases_ = cases;
  std::ranges::fill(observations_.all(), Observation{});
}

void ObservedPairs::end_part() {
  for (CaseNumber number = cases_.begin; number < cases_.end; ++number) {
    const Observation& observed = observations_[number - cases_.begin];
    if (!observed.is_there) continue;
    if (!observed.is_well_posed) {
      take_in(number, observed, {});
      continue;
    }
    for (std::size_t i = 0; i < aim_.gauges; ++i) {
      if (observed.gauges[i] > worst_[i].value) worst_[i] = {observed.gauges[i], number};
    }
    take_in(number, observed,
            archive_.add(observed, aim_.value(observed), [&] { return to_keep(number); }));
  }
}

}  // namespace manifuzz
