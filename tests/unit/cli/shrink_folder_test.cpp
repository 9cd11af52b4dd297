#include <algorithm>
#include <filesystem>
#include <set>

#include <catch2/catch.hpp>

#include "support/interruption.hpp"
#include "unit/cli/one_eyed.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

std::vector<CorpusCase> cases_of(const TemporaryFolder& folder) {
  const fs::path corpus = corpus_in(folder);
  const Corpus read = read_corpus({&corpus, 1});
  CHECK(read.errors.empty());
  return read.cases;
}

std::ptrdiff_t unshrunk(const TemporaryFolder& folder) {
  return std::ranges::count_if(cases_of(folder),
                               [](const CorpusCase& known) { return known.found->is_unshrunk; });
}

/// The buckets of the smallest cases; each once.
std::set<std::string> buckets_of(const TemporaryFolder& folder) {
  std::set<std::string> buckets;
  for (const CorpusCase& known : cases_of(folder)) {
    if (!is_worst(known.path)) CHECK(buckets.insert(known.expect->bucket).second);
  }
  return buckets;
}

std::vector<std::string> shrink(const TemporaryFolder& folder, const std::string& subject) {
  return {"shrink", corpus_in(folder), "--subject-command", subject};
}

}  // namespace

TEST_CASE("what a campaign had no time to shrink is counted, and shrink DIR goes on with it") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const Json run = json_of(campaign(folder, subject));
  const std::vector<CorpusCase> before = cases_of(folder);
  CHECK(run["unshrunk"] == before.size());
  CHECK(unshrunk(folder) == std::ssize(before));
  const auto buckets = buckets_of(folder);
  CHECK(accept(folder, {before.front().path}).status == 0);
  const Outcome outcome = run_manifuzz(shrink(folder, subject));
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(lines_of(outcome.out).size() == before.size());
  CHECK(unshrunk(folder) == 0);
  CHECK(buckets_of(folder) == buckets);
  std::vector<std::string> accepted;
  for (const CorpusCase& known : cases_of(folder)) {
    if (known.accepted) accepted.push_back(known.path);
    CHECK(known.found->seen);
    if (is_worst(known.path)) {
      const bool was_there = std::ranges::any_of(
          before, [&](const CorpusCase& other) { return other.any == known.any; });
      CHECK(was_there);
    }
  }
  REQUIRE(accepted.size() == 1);  // not of the worst too
  CHECK(read_case_file(accepted.front()).expect->bucket == before.front().expect->bucket);
  CHECK_FALSE(is_worst(accepted.front()));
  CHECK(run_manifuzz(shrink(folder, subject)).out.empty());
}

TEST_CASE("shrink DIR that is interrupted loses no case, and goes on the next time") {
  const TemporaryFolder folder;
  save_findings(folder, one_eyed(folder));
  const auto buckets = buckets_of(folder);
  const Outcome outcome = run_interruptible(shrink(folder, interrupting_blind(folder, 60)));
  CHECK(outcome.status == 130);
  CHECK_THAT(outcome.err, Contains("interrupted"));
  CHECK(buckets_of(folder) == buckets);
  CHECK(unshrunk(folder) > 0);
  const Outcome again = run_manifuzz(shrink(folder, one_eyed(folder)));
  CHECK(again.status == 0);
  CHECK(buckets_of(folder) == buckets);
  CHECK(unshrunk(folder) == 0);
}

TEST_CASE("a case that cannot be shrunk any more keeps none of the others from it") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const auto files = save_findings(folder, subject);
  std::string agreeing = text_of(files.front());
  const std::size_t position = agreeing.find("\"position\": [");
  agreeing.replace(position, agreeing.find(']', position) - position, "\"position\": [900,900");
  const std::string broken = folder.write("corpus/agreeing.json", agreeing);
  const Outcome outcome = run_manifuzz(shrink(folder, subject));
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains(broken + ": one_eyed and box2d agree on it"));
  CHECK(text_of(broken) == agreeing);
  CHECK(lines_of(outcome.out).size() == files.size());
}

TEST_CASE("two cases that shrink to one leave that one, the worse of both beside it") {
  const TemporaryFolder folder;
  const std::string subject = one_eyed(folder);
  const std::string file = save_findings(folder, subject).front();
  const CorpusCase given = read_case_file(file);
  fs::remove_all(corpus_in(folder));
  fs::create_directory(corpus_in(folder));
  CorpusCase milder = given;
  milder.expect->magnitude = given.expect->magnitude.value() / 2;
  milder.accepted = Acceptance{.because = "so"};
  folder.write("corpus/one.json", format_case(given));
  folder.write("corpus/two.json", format_case(milder));
  CHECK(run_manifuzz(shrink(folder, subject)).status == 0);
  const std::vector<CorpusCase> left = cases_of(folder);
  REQUIRE(left.size() == 2);
  for (const CorpusCase& known : left) {
    CHECK(known.accepted.has_value() != is_worst(known.path));
    if (is_worst(known.path)) CHECK(known.expect->magnitude == given.expect->magnitude);
  }
}

TEST_CASE("shrink DIR says what it lacks", "[bad-input]") {
  const TemporaryFolder folder;
  const auto files = save_findings(folder, one_eyed(folder));
  const Outcome nobody = run_manifuzz({"shrink", corpus_in(folder)});
  CHECK(nobody.status == 2);
  const auto lines = lines_of(nobody.err);
  REQUIRE(lines.size() >= files.size());
  CHECK_THAT(lines.front(), Contains("its subject 'one_eyed' is not at hand"));
  CHECK(unshrunk(folder) == std::ssize(files));
  const Outcome to_file = run_manifuzz({"shrink", corpus_in(folder), "--output", "x.json"});
  CHECK(to_file.status == 2);
  CHECK(is_one_clear_line(to_file.err));
  fs::create_directory(folder.path() / "empty");
  CHECK(run_manifuzz({"shrink", folder.path() / "empty"}).status == 0);
}
