#include "canary/worst_cases.hpp"

#include "generating/regime.hpp"
#include "oracle/box2d/box2d.hpp"

namespace manifuzz::canary {

WorstCases worst_cases(const Collider& subject, std::uint64_t seed, std::uint64_t cases) {
  static const Collider oracle = make_box2d();
  WorstCases found;
  for (std::uint64_t number = 0; number < cases; ++number) {
    const Regime& regime = polygon_regimes()[number % polygon_regimes().size()];
    const PairCase pair = generate(seed, regime, number / polygon_regimes().size());
    const auto blamed = blame(pair, subject, oracle);
    if (!blamed) continue;
    ++found.wrong;
    if (blamed->bucket.error_class == ErrorClass::gross) ++found.gross;
    const auto [known, is_first] =
        found.by_bucket.try_emplace(to_string(blamed->bucket), std::pair(*blamed, pair));
    if (!is_first && blamed->magnitude > known->second.first.magnitude) {
      known->second = {*blamed, pair};
    }
  }
  return found;
}

}  // namespace manifuzz::canary
