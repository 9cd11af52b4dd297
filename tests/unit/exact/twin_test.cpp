#include "support/twin.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/moved.hpp"
#include "support/named_tests.hpp"

// The judge against its twin, in every regime: on what colliders answer, and on answers moved by
// about as much as the bounds allow. MANIFUZZ_TWIN_CASES sets how many a regime.

namespace manifuzz {
namespace {

std::vector<TwinCandidate> judged_candidates(const Admissible& right) {
  std::vector<TwinCandidate> candidates;
  for (const exact::Clip* clip : right.candidates) {
    candidates.push_back({clip->reference.side, clip->reference.index, clip->incident});
  }
  return candidates;
}

void compare(const Regime& regime) {
  const std::array<Collider, 3> colliders{make_clip(), make_clip64(), make_box2d()};
  std::vector<PairCase> corpus;
  for (std::uint64_t i = 0; i < 20; ++i) corpus.push_back(generate(3, *find_regime("grid"), i));
  for (std::uint64_t i = 0; i < twin_cases(regime.is_round ? 500 : 2000); ++i) {
    const PairCase pair = generate(11, regime, i, {.corpus = corpus, .radius = {}});
    Random random(11, "answers", i);
    Collider subject = colliders[random.chance(0.5) ? 0 : 1];
    // Box2D takes few round pairs.
    const Collider& oracle = colliders[random.chance(is_round(pair) ? 0.75 : 0.25) ? 1 : 2];
    if (is_round(pair)) subject.declaration.second_point = any_policy(random);
    const Answer right = subject.collide(pair);
    const Answer of_subject = moved(right, pair, subject.declaration, random);
    const Answer of_oracle = oracle.collide(pair);
    const ColliderAnswer s{subject.declaration, of_subject};
    const ColliderAnswer o{oracle.declaration, of_oracle};
    std::string line;
    append_case_line(line, pair);
    INFO(line << "\n"
              << subject.declaration.name << " against " << oracle.declaration.name << ", index "
              << i);
    const TwinJudgement twin = twin_judge(pair, s, o);
    REQUIRE(standing(exact::Truth(pair)).touching == twin.touching);
    REQUIRE(judged_candidates(admissible(pair, s.declaration)) == twin.candidates);
    REQUIRE(to_string(as_twin_has_it(judge(pair, s, o).bucket, pair)) ==
            to_string(as_twin_has_it(twin.bucket, pair)));
  }
}

[[maybe_unused]] const bool registered = [] {
  for (const Regime& regime : regimes()) {
    test::add_test("the judge and its twin agree in the regime " + std::string(regime.name),
                   "[twin]", [&regime] { compare(regime); });
  }
  return true;
}();

}  // namespace
}  // namespace manifuzz
