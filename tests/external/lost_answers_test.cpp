#include <algorithm>
#include <fcntl.h>
#include <string>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "campaign/pairs/recorded_case.hpp"
#include "external/campaigns.hpp"
#include "generating/regime.hpp"
#include "judging/manifold_error.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/temporary_folder.hpp"

// Which case lost its answer, and why: none but the one that the collider fails at.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

/// While it lives, what is written to the standard error of this process and its children goes to
/// a file.
class CapturedErrors {
 public:
  CapturedErrors() : path_(folder_.write("errors", "")), before_(dup(STDERR_FILENO)) {
    const int file = open(path_.c_str(), O_WRONLY | O_APPEND);
    dup2(file, STDERR_FILENO);
    close(file);
  }
  ~CapturedErrors() {
    dup2(before_, STDERR_FILENO);
    close(before_);
  }
  CapturedErrors(const CapturedErrors&) = delete;
  CapturedErrors& operator=(const CapturedErrors&) = delete;

  std::string text() const { return text_of(path_); }

 private:
  TemporaryFolder folder_;
  std::string path_;
  int before_;
};

std::size_t length_passed_on(const std::string& errors) {
  return static_cast<std::size_t>(std::ranges::count(errors, 'x'));
}

std::size_t lines_with(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("a crash is one crash, however the program writes and however many jobs ask it") {
  for (const char* behaviour : {"crashes", "exits", "buffers-and-crashes", "breaks-off"}) {
    Plan plan = plan_of(program(behaviour));
    const std::uint64_t expected = unlucky(plan);
    REQUIRE(expected > 1);
    for (const int jobs : {1, 2, 4}) {
      CAPTURE(behaviour, jobs);
      plan.jobs = jobs;
      const JobsResult result = run(plan);
      CHECK(result.tally->cases() == kCases);
      CHECK(result.tally->count(Verdict::crashed) == expected);
      CHECK(result.tally->unexplained() == expected);
    }
  }
}

TEST_CASE("a program that dies of no case in particular is seen to crash") {
  const JobsResult result = run(plan_of(program("tires")));
  CHECK(result.tally->cases() == kCases);
  CHECK(result.tally->count(Verdict::crashed) > 0);
  CHECK(result.tally->unexplained() == result.tally->count(Verdict::crashed));
}

TEST_CASE("answers that a program owes when it is stopped are not taken for later ones") {
  const Collider late = collider_of_command(MANIFUZZ_TEST_PROGRAM " late", 60);
  const Regime& regime = *find_regime("boxes");
  const PairCase first = generate(1, regime, 0);
  const PairCase second = generate(1, regime, 1);
  const Answer right = late.collide(second);
  REQUIRE_FALSE(is_same(late.collide(first), right));
  Answer answer;
  int asked = 0;
  const auto go_on = [&asked] { return asked++ == 0; };
  CHECK(late.collide_many({&first, 1}, {&answer, 1}, go_on) == 0);
  CHECK(is_same(late.collide(second), right));
}

TEST_CASE("the start of a program is on no case's clock") {
  const TemporaryFolder folder;
  const std::string again = (folder.path() / "again").string();
  const Collider slow_again =
      collider_of_command(fmt::format("mkdir {} 2>/dev/null || sleep 1.5; exec {} crashes", again,
                                      MANIFUZZ_TEST_PROGRAM),
                          kSecondsMax);
  const Answer answer = slow_again.collide(generate(1, *find_regime("boxes"), 0));
  CHECK_FALSE(std::holds_alternative<Lost>(answer));
}

TEST_CASE("a malformed answer says why in the case that is saved") {
  const Collider subject = program("negative");
  Plan plan = plan_of(subject);
  const JobsResult result = run(plan);
  CHECK(result.tally->count(Verdict::malformed) == unlucky(plan));
  const Bucket bucket = bucket_of_lost(Verdict::malformed, Fault::subject);
  const PairCase pair = plan.pair(result.tally->buckets.find(bucket)->first);
  Interruption interruption;
  const CorpusCase saved =
      recorded_case(pair, {.bucket = bucket}, subject, plan.oracle, interruption);
  INFO(saved.note);
  CHECK(saved.note.ends_with(" behaving: point 0: depth -0.25 is below 0; 0 or more is expected."));
}

TEST_CASE("of what a program writes to its standard error, so much a case and a run is passed on") {
  const Regime& regime = *find_regime("boxes");
  {
    const CapturedErrors errors;
    const Collider complaining = program("complains");  // asks it one case
    CHECK(length_passed_on(errors.text()) == kErrorBytesACase);
    CHECK(lines_with(errors.text(), "the rest is dropped\n") == 1);
    for (std::uint64_t i = 0; i < 20; ++i) complaining.collide(generate(1, regime, i));
    CHECK(length_passed_on(errors.text()) == kErrorBytesARun);
    CHECK(lines_with(errors.text(), "the rest is dropped\n") == 1);
  }
  const CapturedErrors errors;
  program("");
  CHECK(errors.text().empty());
}
