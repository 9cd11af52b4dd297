#include <algorithm>
#include <string>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "campaign/in_child.hpp"
#include "campaign/smoke.hpp"
#include "external/behaviour.hpp"
#include "external/campaigns.hpp"
#include "generating/regime.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/temporary_folder.hpp"

// How often programs are started, and that their starts are on no campaign's clock.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

/// The program that counts its starts in a file, and takes so many seconds over each.
class Counted {
 public:
  explicit Counted(const std::string& behaviour, const std::string& seconds = "0")
      : log_(folder_.write("starts", "")), behaviour_(behaviour), seconds_(seconds) {}

  Collider collider() const {
    return collider_of_command("echo start >> '" + log_ + "'; sleep " + seconds_ +
                                   "; exec " MANIFUZZ_TEST_PROGRAM " " + behaviour_,
                               kSecondsMax);
  }
  std::ptrdiff_t starts() const {
    const std::string log = text_of(log_);
    return std::ranges::count(log, '\n');
  }

 private:
  TemporaryFolder folder_;
  std::string log_;
  std::string behaviour_;
  std::string seconds_;
};

/// Some cases of the plan that the program fails at.
std::vector<PairCase> unlucky_cases(const Plan& plan, std::size_t count) {
  std::vector<PairCase> cases;
  for (CaseNumber number = 0; cases.size() < count; ++number) {
    const PairCase pair = plan.pair(number);
    const float x = pair.a.polygon.vertices[0].x();
    if (is_unlucky(x, pair.b.pose.position.y())) cases.push_back(pair);
  }
  return cases;
}

/// Beside clip64.
Shrunk shrunk(const PairCase& pair, const Collider& subject) {
  Interruption interruption;
  return shrink_finding(pair, subject, make_clip64(), interruption);
}

}  // namespace

TEST_CASE("a program is started once for all findings, and answers as one that is started anew") {
  const Counted counted("negative");
  const Collider subject = counted.collider();
  Interruption interruption;
  for (const PairCase& pair : unlucky_cases(plan_of(subject), 3)) {
    const Shrunk smallest = shrunk(pair, subject);
    const Shrunk anew = shrunk(pair, program("negative"));
    CHECK(smallest.pair == anew.pair);
    CHECK(smallest.evaluations == anew.evaluations);
    CHECK(smallest.evaluations > 1);
    const Grid grid = grid_around(exact::Truth(pair));
    const Neighbourhood map =
        ask_neighbourhood(pair, subject, make_clip64(), grid, 100, interruption);
    CHECK(std::ranges::count(map.cells, Cell::State::not_asked, &Cell::state) ==
          grid.cell_count() - 100);
  }
  CHECK(counted.starts() == 1);
}

TEST_CASE("a finding of a program is shrunk although the other collider dies of it") {
  Collider dying = make_clip64();
  dying.collide = [clip64 = make_clip64()](const PairCase& pair) {
    if (pair.b.polygon.count == 5) _exit(3);
    return clip64.collide(pair);
  };
  const Counted counted("");
  const Collider subject = counted.collider();
  Plan plan = plan_of(subject);
  CaseNumber number = 0;
  while (plan.pair(number).b.polygon.count != 5) ++number;
  Interruption interruption;
  const Shrunk smallest = shrink_finding(plan.pair(number), subject, dying, interruption);
  CHECK(smallest.complete);
  CHECK(smallest.pair.b.polygon.count == 5);
  CHECK(smallest.pair.a.polygon.count == 3);
  CHECK(judge_in_child(smallest.pair, subject, dying, interruption).bucket.verdict ==
        Verdict::crashed);
  CHECK(counted.starts() == 1);
}

TEST_CASE("shrinking that has no time keeps the case, and the program") {
  const Counted counted("negative");
  const Collider subject = counted.collider();
  const PairCase pair = unlucky_cases(plan_of(subject), 1).front();
  Interruption interruption;
  const Shrunk none =
      shrink_finding(pair, subject, make_clip64(), interruption, Deadline(Clock::now()));
  CHECK(none.pair == pair);
  CHECK_FALSE(none.complete);
  CHECK_NOTHROW(judge_in_child(pair, subject, make_clip64(), interruption));
  CHECK(counted.starts() == 1);
}

TEST_CASE("a campaign's time begins with its first answer, however long a program starts") {
  const Counted slow("", "0.4");
  Plan plan = plan_of(slow.collider());
  plan.cases.reset();
  plan.seconds = 0.1;
  const JobsResult result = run(plan);
  CHECK(result.tally->cases() > 0);
  CHECK_FALSE(result.interrupted);
}

TEST_CASE("a campaign that must be over by then is, whatever was answered") {
  Plan plan = plan_of(program("late"));
  plan.cases.reset();
  plan.seconds = 1e9;
  plan.latest = Clock::now();
  CHECK(run(plan).tally->cases() <= 2);
}

TEST_CASE("smoke leaves its campaign time for another start of a slow program") {
  const Counted slow("", "1.5");
  SmokePlan plan;
  plan.start = Clock::now();
  plan.seconds = 6;
  plan.subject = slow.collider();
  plan.start_seconds = seconds_since(plan.start);
  plan.oracle = make_clip64();
  plan.origin.provenance = {{"machine", {}}, {"compiler", ""}, {"versions", {}}};
  Interruption all(kUntilSignal);
  const SmokeRun run = run_smoke(plan,
                                 {.on_replayed = [](const auto&) {},
                                  .on_checked = [](const auto&) {},
                                  .on_campaign = [](const auto&) {},
                                  .on_progress = [](const auto&, const auto&) {}},
                                 all);
  REQUIRE(run.campaign);
  CHECK(run.campaign->result.cases() > 0);
  for (const CheckedProperty& checked : run.checked) CHECK(checked.holds());
}
