#include <csignal>
#include <string>
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "external/behaviour.hpp"
#include "external/campaigns.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/run_program.hpp"

// Every way to end a process, or to keep it busy for ever, loses the case that it is done on, and
// no other.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

std::string raises(int signal) {
  return "raises-" + std::to_string(signal);
}

/// Behaviours that end the process at once, whatever it is.
const std::vector<std::string>& ways_to_end() {
  static const std::vector<std::string> all{
      "aborts",        "terminates",    "throws",       "allocates",     "overflows",
      "overwrites",    "quick-exits",   "exits",        "calls-exit",    "becomes-another",
      raises(SIGKILL), raises(SIGSEGV), raises(SIGFPE), raises(SIGBUS),  raises(SIGILL),
      raises(SIGTERM), raises(SIGINT),  raises(SIGHUP), raises(SIGALRM), raises(SIGPIPE),
      raises(SIGXCPU), raises(SIGSYS)};
  return all;
}

/// Five cases, of which a collider that is told so fails at the third.
std::vector<PairCase> cases_around_unlucky() {
  const Plan plan = plan_of(make_clip64());
  std::vector<PairCase> unlucky_ones;
  std::vector<PairCase> others;
  for (CaseNumber number = 0; unlucky_ones.empty() || others.size() < 4; ++number) {
    const PairCase pair = plan.pair(number);
    const bool is_one = is_unlucky(pair.a.polygon.vertices[0].x(), pair.b.pose.position.y());
    (is_one ? unlucky_ones : others).push_back(pair);
  }
  return {others[0], others[1], unlucky_ones[0], others[2], others[3]};
}

/// A batch that has an unlucky case in its middle loses that one alone.
void check_loses_one(const Collider& subject, Lost::How how) {
  static const std::vector<PairCase> pairs = cases_around_unlucky();
  std::vector<Answer> answers(pairs.size());
  REQUIRE(subject.collide_many(pairs, answers, [] { return true; }) == pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    CAPTURE(i);
    const auto* const lost = std::get_if<Lost>(&answers[i]);
    CHECK((lost != nullptr) == (i == 2));
    if (lost != nullptr) CHECK(lost->how == how);
  }
}

}  // namespace

TEST_CASE("a library in a process of its own may end it in any way, and loses that case alone") {
  for (const std::string& way : ways_to_end()) {
    CAPTURE(way);
    const Told told(way.c_str());
    check_loses_one(library(), Lost::How::crashed);
  }
  CHECK(waitpid(-1, nullptr, WNOHANG) == -1);
}

TEST_CASE("a program may end in any way, and loses that case alone") {
  for (const std::string& way : ways_to_end()) {
    CAPTURE(way);
    check_loses_one(program(way), Lost::How::crashed);
  }
  CHECK(waitpid(-1, nullptr, WNOHANG) == -1);
}

TEST_CASE("one that spins, or lets no signal through, loses that case when its time is over") {
  check_loses_one(program("is-deaf"), Lost::How::timed_out);
  const Told told("spins");
  check_loses_one(library(), Lost::How::timed_out);
}

TEST_CASE("one that closes all that is open loses that case alone") {
  check_loses_one(program("closes-all"), Lost::How::crashed);
  const Told told("closes-all");
  check_loses_one(library(), Lost::How::crashed);
}

TEST_CASE("what a library in a process of its own prints is in no output of the campaign") {
  const Told told("prints");
  const test::Outcome outcome =
      run_manifuzz({"fuzz", "--subject", MANIFUZZ_TEST_LIBRARY, "--oracle", "clip64", "--cases",
                    "2000", "--seed", "1", "--no-save", "--json", "-"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(nlohmann::json::parse(outcome.out, nullptr, false)["cases"] == 2000);
}
