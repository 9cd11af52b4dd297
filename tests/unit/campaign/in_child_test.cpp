#include "campaign/in_child.hpp"

#include <memory>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "campaign/pairs/pair_trial.hpp"
#include "campaign/replay.hpp"
#include "generating/regime.hpp"
#include "judging/manifold_error.hpp"
#include "own_colliders/own_colliders.hpp"
#include "process/pool.hpp"

using namespace manifuzz;

namespace {

constexpr int kDeath = 9;  // not by a signal, which the test framework would catch

/// `clip`, but for what it does before each call, of which it is told how many there were in all
/// processes.
Collider spoilt(const std::function<void(int call)>& spoil) {
  const auto calls = std::make_shared<Shared<std::atomic<int>>>();
  Collider collider = make_clip();
  collider.collide = [clip = make_clip(), spoil, calls](const PairCase& pair) {
    spoil(++**calls);
    return clip.collide(pair);
  };
  return collider;
}

PairCase some_case() {
  return generate(1, *find_regime("deep"), 0);
}

}  // namespace

TEST_CASE("one that dies on every second call takes nobody along, and is asked once") {
  const Collider collider = spoilt([](int call) {
    if (call % 2 == 0) _exit(kDeath);
  });
  Interruption interruption;
  const Answer first = ask_in_child(collider, some_case(), interruption);
  CHECK(std::get<Manifold<double>>(first) ==
        std::get<Manifold<double>>(make_clip().collide(some_case())));
  const Answer second = ask_in_child(collider, some_case(), interruption);
  CHECK(std::get<Lost>(second).how == Lost::How::crashed);
  CHECK(
      std::holds_alternative<Manifold<double>>(ask_in_child(collider, some_case(), interruption)));
}

TEST_CASE("a hosted collider dies alone, and answers the next case again") {
  const Collider collider = hosted(spoilt([](int call) {
    if (call == 2) _exit(kDeath);
  }));
  CHECK(collider.is_isolated());
  const Answer right = make_clip().collide(some_case());
  for (const bool is_there : {true, false, true, true}) {
    const Answer answer = collider.collide(some_case());
    CHECK(std::holds_alternative<Lost>(answer) != is_there);
    if (is_there) CHECK(is_same(answer, right));
  }
}

TEST_CASE("every kind of answer comes back from a child") {
  Interruption interruption;
  Collider collider = make_clip();
  collider.collide = [](const PairCase&) { return Unsupported{"why not"}; };
  CHECK(std::get<Unsupported>(ask_in_child(collider, some_case(), interruption)).why == "why not");
  collider.collide = [](const PairCase&) { return Lost{Lost::How::malformed, "nonsense"}; };
  const Answer lost = ask_in_child(collider, some_case(), interruption);
  CHECK(std::get<Lost>(lost).how == Lost::How::malformed);
  CHECK(std::get<Lost>(lost).why == "nonsense");
  collider.collide = [](const PairCase& pair) {
    return PartialManifold{.manifold = std::get<Manifold<double>>(make_clip().collide(pair))};
  };
  CHECK(std::get<Manifold<double>>(ask_in_child(collider, some_case(), interruption)) ==
        std::get<Manifold<double>>(make_clip().collide(some_case())));
}

TEST_CASE("a property's replay asks once, in a child") {
  const Collider collider = spoilt([](int call) {
    if (call > 1) _exit(kDeath);
  });
  Interruption interruption;
  CorpusCase recorded;
  recorded.any = some_case();
  recorded.property = "never-empty";
  CHECK(replay_case(recorded, *trial_of_pairs(collider, collider), {}, interruption).passed);
  const Replayed again =
      replay_case(recorded, *trial_of_pairs(collider, collider), {}, interruption);
  CHECK_FALSE(again.passed);
  CHECK(again.got == "crashed");
}

TEST_CASE("a collider that dies fails the property, the case at work being the failing one") {
  Collider collider = make_clip();
  collider.collide = [clip = make_clip()](const PairCase& pair) {
    if (pair.b.polygon.count == 5) _exit(kDeath);
    return clip.collide(pair);
  };
  const Property& property = *find_by_name(properties(), "never-empty");
  const PropertyResult result = run_property(property, collider, {3, 500, {}, {}});
  CHECK_FALSE(result.passed);
  CHECK(result.why == "crashed");
  REQUIRE(result.failing.has_value());
  CHECK(result.failing->b.polygon.count == 5);
  CHECK(result.reproduce.empty());
  CHECK(result.report.find("Falsifiable") != std::string::npos);
  CHECK(run_property(property, collider, {3, 500, {}, {}}).report == result.report);
}

TEST_CASE("a property that there is no time for ends at once, whatever was asked of it") {
  Interruption interruption({.hurried_at = Clock::now()});
  const PropertyPlan plan{3, 100'000'000, {}, {}, &interruption};
  const PropertyResult result =
      run_property(*find_by_name(properties(), "never-empty"), make_clip(), plan);
  CHECK(result.passed);
  CHECK(result.cases < plan.cases);
  CHECK(result.report.find("then it was stopped") != std::string::npos);
}
