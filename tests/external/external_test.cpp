#include <csignal>
#include <cstdlib>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "external/campaigns.hpp"
#include "generating/regime.hpp"
#include "own_colliders/own_colliders.hpp"
#include "process/child.hpp"
#include "process/pool.hpp"
#include "support/run_program.hpp"

// Colliders in a process of their own: whatever they do, the campaign ends, counts it and leaves
// nobody behind.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

/// The campaign stops, having seen enough.
void check_ends_campaign(const Collider& subject, Verdict verdict) {
  const JobsResult result = run(plan_of(subject));
  CHECK(result.given_up == Fault::subject);
  CHECK(result.tally->cases() < kCases);
  CHECK(result.tally->count(verdict) >= 20);
}

bool has_children() {
  return waitpid(-1, nullptr, WNOHANG) >= 0;
}

}  // namespace

TEST_CASE("a library out of process, in process and clip64 itself agree") {
  for (const Collider& collider : {library(), collider_in_process(MANIFUZZ_TEST_LIBRARY),
                                   program(""), program("undeclared")}) {
    INFO(collider.declaration.description);
    const JobsResult result = run(plan_of(collider));
    CHECK(result.tally->cases() == kCases);
    CHECK(result.tally->unexplained() == 0);
    CHECK(result.tally->touching() > kCases / 3);
  }
  CHECK_FALSE(has_children());
}

TEST_CASE("what a library and a program declare is read") {
  const Declaration of_library = library().declaration;
  CHECK(of_library.name == "behaving");
  CHECK(of_library.version == "1.0");
  CHECK(of_library.scalar == ScalarType::float64);
  CHECK(of_library.frame == RoundingFrame::local);
  CHECK(program("").declaration.name == "behaving");
  const Declaration undeclared = program("undeclared").declaration;
  CHECK(undeclared.name == "undeclared");
  CHECK(undeclared.scalar == ScalarType::float32);
  CHECK(undeclared.frame == RoundingFrame::world);
}

TEST_CASE("a library that crashes or hangs loses that case alone") {
  const Told crashes("crashes");
  check_loses(library(), Verdict::crashed);
  const Told exits("exits");
  check_loses(library(), Verdict::crashed);
  const Told sleeps("sleeps");
  check_loses(library(), Verdict::timed_out);
}

TEST_CASE("a library's nonsense is a verdict") {
  const Told garbage("garbage");
  check_loses(library(), Verdict::malformed);
  const Told nan("nan");
  const JobsResult result = run(plan_of(library()));
  CHECK(result.tally->count(Verdict::malformed) > kCases / 3);
}

TEST_CASE("a library's wrong depths are found") {
  const Told shallow("shallow");
  CHECK(run(plan_of(library())).tally->count(Verdict::subject_wrong) > kCases / 4);
}

TEST_CASE("a program that crashes, ends, hangs or answers nonsense loses that case alone") {
  check_loses(program("crashes"), Verdict::crashed);
  check_loses(program("exits"), Verdict::crashed);
  check_loses(program("sleeps"), Verdict::timed_out);
  check_loses(program("garbage"), Verdict::malformed);
  check_loses(program("nonsense"), Verdict::malformed);
  check_loses(program("not-a-number"), Verdict::malformed);
  CHECK_FALSE(has_children());
}

TEST_CASE("a program that answers twice, or not at all, is not called wrong for it") {
  // Which case it was is a matter of time, on a busy machine: others may be blamed beside it.
  const JobsResult twice = run(plan_of(program("twice")));
  CHECK(twice.tally->count(Verdict::malformed) > 0);
  CHECK(twice.tally->count(Verdict::subject_wrong) == 0);
  const JobsResult never = run(plan_of(program("never")));
  CHECK(never.tally->count(Verdict::timed_out) > 0);
  CHECK(never.tally->count(Verdict::subject_wrong) == 0);
}

TEST_CASE("a program that answers out of order has no answers") {
  const Collider late =
      collider_of_command(MANIFUZZ_TEST_PROGRAM " out-of-order", kSecondsMax / 10, kSecondsMax);
  const JobsResult result = run(plan_of(late));
  CHECK(result.given_up == Fault::subject);
  // Alone it gives another case's answer, or waits for the next case.
  CHECK(result.tally->count(Verdict::malformed) + result.tally->count(Verdict::timed_out) >= 20);
  CHECK(result.tally->count(Verdict::subject_wrong) == 0);
}

TEST_CASE("one that never answers ends the campaign") {
  check_ends_campaign(program("dies"), Verdict::crashed);
  check_ends_campaign(program("dies-at-start"), Verdict::crashed);
  const Told dies("dies");
  check_ends_campaign(library(), Verdict::crashed);
  CHECK_FALSE(has_children());
}

TEST_CASE("a library that exits in this process loses that case alone") {
  const Told exits("calls-exit");
  check_loses(collider_in_process(MANIFUZZ_TEST_LIBRARY), Verdict::crashed);
}

TEST_CASE("a program's own children end with the command that ran it") {
  const Shared<pid_t> orphan;
  const pid_t command = spawn([&] {
    const Descendants descendants;
    const pid_t program = fork();
    if (program == 0) {
      const pid_t forked = fork();
      if (forked == 0) pause();
      *orphan = forked;
      _exit(0);
    }
    waitpid(program, nullptr, 0);
  });
  CHECK(wait_for(command));
  REQUIRE(*orphan > 0);
  CHECK(kill(*orphan, 0) == -1);
}

TEST_CASE("what cannot be loaded or run is a user's error") {
  CHECK_THROWS_AS(
      collider_of_command(R"(echo '{"declaration": {"snippet": "@a.corner@"}}')", kSecondsMax),
      UserError);
  CHECK_THROWS_AS(collider_in_own_process("./no-such.so", kSecondsMax), UserError);
  CHECK_THROWS_AS(collider_in_process("./no-such.so"), UserError);
  CHECK_THROWS_AS(collider_of_command("./no-such-program", kSecondsMax), UserError);
  CHECK_THROWS_AS(collider_of_command(R"(echo '{"declaration": {"scalar": "int"}}')", kSecondsMax),
                  UserError);
}

TEST_CASE("a collider is not asked what is beyond its limits") {
  Collider chipmunk = collider_in_own_process(MANIFUZZ_TEST_CHIPMUNK, kSecondsMax);
  PairCase pair = generate(1, *find_regime("boxes"), 0);
  pair.a.polygon.radius = 0.5F;
  CHECK(std::holds_alternative<Unsupported>(chipmunk.collide(pair)));
  pair.a.polygon.radius = pair.b.polygon.radius = 0;
  CHECK_FALSE(std::holds_alternative<Unsupported>(chipmunk.collide(pair)));
}

TEST_CASE("a library is timed beside what the interface takes, which is subtracted") {
  const test::Outcome outcome =
      test::run_manifuzz({"bench", "--quick", "--collider", MANIFUZZ_TEST_LIBRARY, "--json", "-"});
  REQUIRE(outcome.status == 0);
  const auto rows = nlohmann::json::parse(outcome.out).at("rows");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0]["collider"] == "box2d");
  CHECK_FALSE(rows[0].contains("ns_without_interface"));
  CHECK(rows[1]["collider"] == "interface");
  CHECK(rows[1]["ns_without_interface"] == 0);
  CHECK(rows[2]["ns_without_interface"].get<double>() < rows[2]["ns_per_pair"].get<double>());
  CHECK(rows[2].contains("error"));
}
