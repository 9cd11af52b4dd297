#include <algorithm>
#include <cfenv>
#include <string>
#include <sys/wait.h>

#include <catch2/catch.hpp>

#include "external/campaigns.hpp"
#include "generating/regime.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

// Programs and libraries that do more than answer: none of it hangs a campaign or changes what
// others answer, and all of it is told.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

/// Why the first of the cases that the campaign lost was lost.
std::string why_lost(const Collider& subject) {
  const Plan plan = plan_of(subject);
  for (CaseNumber number = 0; number < plan.cases_max(); ++number) {
    const Answer answer = subject.collide(plan.pair(number));
    if (const auto* const lost = std::get_if<Lost>(&answer)) return lost->why;
  }
  return "";
}

void check_loses_wherever_it_runs(const char* behaviour, const std::string& why) {
  CAPTURE(behaviour);
  const Told told(behaviour);
  for (const Collider& subject : {collider_in_process(MANIFUZZ_TEST_LIBRARY), library()}) {
    check_loses(subject, Verdict::malformed);
    CHECK(why_lost(subject) == why);
    CHECK(std::fegetround() == FE_TONEAREST);
  }
}

std::size_t children() {
  std::size_t count = 0;
  while (waitpid(-1, nullptr, WNOHANG) > 0) ++count;
  return count;
}

}  // namespace

TEST_CASE("a program that is stopped, or hides from the signal that ends it, loses that case") {
  check_loses(program("stops"), Verdict::timed_out);
  check_loses(program("leaves-its-group"), Verdict::timed_out);
}

TEST_CASE("a program whose child keeps its pipe open has died all the same, and soon") {
  const Collider dies = collider_of_command(MANIFUZZ_TEST_PROGRAM " leaves-a-child", 3600);
  check_loses(dies, Verdict::crashed);
  CHECK(why_lost(dies) == "exited with status 3");
}

TEST_CASE("a program that closes its output and lives on is not waited for") {
  check_loses(collider_of_command(MANIFUZZ_TEST_PROGRAM " closes-and-lives-on", 3600),
              Verdict::crashed);
}

TEST_CASE("what a library does to the floating point environment is told and undone") {
  check_loses_wherever_it_runs("rounds-down", "changed the rounding mode");
#if defined(__x86_64__)
  check_loses_wherever_it_runs("flushes",
                               "changed what becomes of subnormal numbers (flush to zero)");
  check_loses_wherever_it_runs("traps", "changed which floating point exceptions trap");
#endif
}

TEST_CASE("what a library forks within a call does not go on in its place") {
  check_loses_wherever_it_runs("forks", "forked this process");
  CHECK(children() <= 1);  // the one that `why_lost` left last
}

TEST_CASE("a library that a process was forked in answers as before") {
  const Told told("forks");
  const Collider forking = collider_in_process(MANIFUZZ_TEST_LIBRARY);
  const PairCase pair = generate(1, *find_regime("boxes"), 0);
  const Answer before = forking.collide(pair);
  why_lost(forking);
  CHECK(is_same(forking.collide(pair), before));
}

TEST_CASE("the time for shrinking holds for a program that has to be started again and again") {
  const TemporaryFolder folder;
  const std::string log = folder.write("starts", "");
  const std::string corpus = (folder.path() / "corpus").string();
  const Outcome outcome = run_manifuzz(
      {"fuzz", "--subject-command",
       "echo start >> '" + log + "'; sleep 0.05; exec " MANIFUZZ_TEST_PROGRAM " twice", "--oracle",
       "clip64", "--cases", "3000", "--seed", "1", "--shrink-seconds", "0.5", "--corpus", corpus});
  CAPTURE(outcome.out);
  CHECK(outcome.status == 1);
  const std::string starts = text_of(log);
  CHECK(std::ranges::count(starts, '\n') < 300);  // a map of its neighbours alone takes 1000
}

TEST_CASE("a finding about which nobody answers in time is saved as it was seen, which is said") {
  const TemporaryFolder folder;
  const std::string corpus = (folder.path() / "corpus").string();
  const Outcome outcome = run_manifuzz(
      {"fuzz", "--subject-command", "read -r line; echo '{\"points\": []}'; sleep 3600",
       "--time-limit", "3", "--oracle", "clip64", "--cases", "1", "--seed", "1", "--shrink-seconds",
       "0", "--corpus", corpus, "--json", (folder.path() / "run.json").string()});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("1 of the new findings are saved as they were seen") != std::string::npos);
  CHECK(std::filesystem::exists(corpus + "/regressions"));
}
