#include <array>

#include <catch2/catch.hpp>

#include "campaign/accept.hpp"
#include "campaign/known.hpp"
#include "generating/regime.hpp"

// What is accepted of a kind: rarer buckets of it too, no worse and no more often.

using namespace manifuzz;
using Catch::Contains;

namespace {

const std::string kToday = "2026-11-26";
const std::string kShown = "subject/subject_wrong/depth/none/a/gross";
const std::string kRarer = "subject/subject_wrong/depth/reference/b/gross";
const std::string kOther = "subject/subject_wrong/normal/none/a/gross";

CorpusCase accepted_of_kind(const std::string& bucket, double per_million) {
  CorpusCase known;
  known.expect = Expectation{"mine", "box2d", "subject_wrong", bucket, {}};
  known.path = bucket + ".json";
  known.accepted = Acceptance{.because = "so", .is_of_kind = true};
  known.accepted->errors_up_to.emplace()[Component::depth] = 0.5;
  known.accepted->per_million["boxes"] = per_million;
  return known;
}

struct Met {
  std::string bucket;
  std::uint64_t count = 0;
  double depth = 0.25;
};

std::vector<Finding> found(const std::vector<CorpusCase>& known, const std::vector<Met>& met) {
  Plan plan;
  plan.subject.declaration.name = "mine";
  plan.oracle.declaration.name = "box2d";
  plan.regimes = {find_regime("boxes")};
  Tally tally;
  tally.regimes[0].cases = 1'000'000;
  for (const Met& one : met) {
    BucketTally& of_bucket = tally.buckets.of(*find_bucket(one.bucket));
    of_bucket.count = of_bucket.regimes[0] = one.count;
    of_bucket.error.magnitude = of_bucket.error.errors[Component::depth] = one.depth;
  }
  return findings(tally, plan, known_of(known, kToday));
}

}  // namespace

TEST_CASE("a rarer bucket of a kind that is accepted is accepted, and not new") {
  const auto all = found({accepted_of_kind(kShown, 100)}, {{kShown, 90}, {kRarer, 3}});
  REQUIRE(all.size() == 2);
  for (const Finding& finding : all) {
    CAPTURE(finding.objection);
    CHECK(finding.is_accepted);
    CHECK_FALSE(finding.is_new);
  }
}

TEST_CASE("without its kind a bucket that no file shows is new") {
  CorpusCase known = accepted_of_kind(kShown, 100);
  known.accepted->is_of_kind = false;
  const auto all = found({known}, {{kRarer, 1}});
  REQUIRE(all.size() == 1);
  CHECK(all.front().is_new);
  CHECK_FALSE(all.front().is_accepted);
}

TEST_CASE("another kind is new, whatever kind is accepted") {
  const auto all = found({accepted_of_kind(kShown, 100)}, {{kOther, 1}});
  REQUIRE(all.size() == 1);
  CHECK(all.front().is_new);
}

TEST_CASE("a rarer bucket that is worse than all of its kind is new") {
  const auto all = found({accepted_of_kind(kShown, 100)}, {{kRarer, 1, 0.75}});
  REQUIRE(all.size() == 1);
  CHECK(all.front().is_new);
  CHECK_THAT(all.front().objection, Contains("worse than is accepted: depth 0.75"));
}

TEST_CASE("rarer buckets of a kind are too many where all together come too often") {
  const auto all = found({accepted_of_kind(kShown, 100)}, {{kShown, 120}, {kRarer, 200}});
  REQUIRE(all.size() == 2);
  for (const Finding& finding : all) {
    if (to_string(finding.bucket) != kRarer) continue;
    CHECK(finding.is_new);
    CHECK_THAT(finding.objection, Contains("more frequent than is accepted in boxes"));
  }
}

TEST_CASE("several files of a kind are accepted together, each with its rate") {
  const std::vector<CorpusCase> known{
      accepted_of_kind(kShown, 100),
      accepted_of_kind("subject/subject_wrong/depth/none/b/gross", 150)};
  const auto all = found(known, {{kShown, 90}, {kRarer, 130}});
  for (const Finding& finding : all) CHECK(finding.is_accepted);
}

TEST_CASE("whole_kind is written and read, and said in words") {
  const CorpusCase known = accepted_of_kind(kShown, 100);
  const std::string text = '{' + acceptance_member(*known.accepted).substr(1) + '}';
  const JsonTree tree = parse_json(text);
  CHECK(read_acceptance(JsonView(tree).at("accepted")).is_of_kind);
  CHECK_THAT(acceptance_in_words(known, kToday), Contains(", and other buckets of its kind"));
}
