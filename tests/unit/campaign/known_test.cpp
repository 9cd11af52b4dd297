#include "campaign/known.hpp"

#include <algorithm>
#include <limits>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "campaign/accept.hpp"
#include "campaign/result.hpp"
#include "engines/colliders.hpp"
#include "generating/regime.hpp"

using namespace manifuzz;
using Catch::Contains;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::string kToday = "2026-11-23";
const std::string kOlder = "subject/subject_wrong/depth/none/a";  // as files once had it
const std::string kGross = kOlder + "/gross";

CorpusCase wrong(const std::string& bucket, const std::string& subject = "mine") {
  CorpusCase known;
  known.expect = Expectation{subject, "box2d", "subject_wrong", bucket, {}};
  known.expect->magnitude = 0.25;
  known.path = bucket + ".json";
  return known;
}

CorpusCase accepted(CorpusCase known, const Acceptance& acceptance) {
  known.accepted = acceptance;
  return known;
}

Collider named(const std::string& name) {
  Collider collider;
  collider.declaration.name = name;
  return collider;
}

Plan plan_of_boxes() {
  Plan plan;
  plan.subject = named("mine");
  plan.oracle = named("box2d");
  plan.regimes = {find_regime("boxes"), find_regime("sliver")};
  return plan;
}

/// A thousand cases of each regime, of which so many of the first are of this bucket, as bad.
Tally tally_of(const std::string& bucket, std::uint64_t count, double magnitude) {
  Tally tally;
  tally.regimes[0].cases = 1000;
  tally.regimes[1].cases = 1200;
  BucketTally& met = tally.buckets.of(*find_bucket(bucket));
  met.count = count;
  met.regimes[0] = count;
  met.error.magnitude = magnitude;
  return tally;
}

/// What a campaign that met this, so often and so badly, makes of it.
Finding found(const CorpusCase& known, const std::string& bucket, std::uint64_t count,
              double magnitude, const std::string& today = kToday) {
  const std::vector<Finding> all =
      findings(tally_of(bucket, count, magnitude), plan_of_boxes(), known_of({&known, 1}, today));
  REQUIRE(all.size() == 1);
  return all.front();
}

bool is_waited_for(const std::string& bucket, double magnitude, const CorpusCase& known,
                   bool has_ties = false) {
  Plan plan = plan_of_boxes();
  plan.has_ties = has_ties;
  return is_new_and_wrong({.bucket = *find_bucket(bucket), .magnitude = magnitude}, plan,
                          known_of({&known, 1}, kToday));
}

}  // namespace

TEST_CASE("an acceptance holds up to its magnitude and on its last day, not beyond") {
  const Acceptance acceptance{.because = "so", .until = "2027-01-31", .up_to = 0.5};
  CHECK(objection(acceptance, {0.5}, "2027-01-31").empty());
  CHECK_THAT(objection(acceptance, {0.51}, "2027-01-31"), Contains("worse than is accepted: 0.51"));
  CHECK_THAT(objection(acceptance, {0.1}, "2027-02-01"), Contains("until 2027-01-31, and that is"));
  CHECK_THAT(objection(acceptance, {kInfinity}, "2026-01-01"), Contains("worse than is accepted"));
  CHECK(objection({.because = "so"}, {kInfinity}, "9999-12-31").empty());
  CHECK(objection({.because = "so", .up_to = 0}, {0}, kToday).empty());
  CHECK_FALSE(objection({.because = "so", .up_to = 0}, {1e-12}, kToday).empty());
}

TEST_CASE("without a bound three times the worst seen is accepted, and at least the case itself") {
  CorpusCase known = wrong(kGross);
  CHECK(acceptance_of(known, {.because = "so"}).up_to == 0.75);
  known.found = Found{1, "boxes", 2, {}};
  known.found->seen = Seen{1'000'000, 0.5, {{"boxes", 100}, {"sliver", 0}}};
  const Acceptance of_campaign = acceptance_of(known, {.because = "so"});
  CHECK(of_campaign.up_to == 1.5);
  CHECK(of_campaign.per_million == std::map<std::string, double>{{"boxes", 135}, {"sliver", 5}});
  known.expect->magnitude = 4;  // shrunk again and again
  CHECK(acceptance_of(known, {.because = "so"}).up_to == 4);
  CHECK(acceptance_of(known, {.because = "so", .up_to = 0}).up_to == 0);
}

TEST_CASE("what does not record how bad it is needs a bound that somebody names") {
  CorpusCase known = wrong(kGross);
  known.expect->magnitude.reset();
  CHECK_THROWS_WITH(acceptance_of(known, {.because = "so"}), Contains("--up-to"));
  CHECK(acceptance_of(known, {.because = "so", .up_to = 0.1}).up_to == 0.1);
}

TEST_CASE("only somebody's mistake can be accepted") {
  for (const char* bucket :
       {"none/agree/none/none/a", "none/tie/depth/none/a", "oracle/known/depth/none/a/gross",
        "none/ill_posed/none/none/a", "no bucket", ""}) {
    CAPTURE(bucket);
    CHECK_THROWS_AS(acceptance_of(wrong(bucket), {.because = "so"}), UserError);
  }
  CHECK_THROWS_AS(acceptance_of(CorpusCase(), {.because = "so"}), UserError);
  CHECK_THROWS_AS(acceptance_of(wrong(kGross, ""), {.because = "so"}), UserError);
  CHECK_NOTHROW(acceptance_of(wrong("subject/crashed/none/none/a"), {.because = "so"}));
  CHECK_NOTHROW(acceptance_of(wrong("oracle/oracle_wrong/depth/none/a/fine"), {.because = "so"}));
  CorpusCase of_property = wrong("");
  of_property.property = "never-empty";
  CHECK_NOTHROW(acceptance_of(of_property, {.because = "so"}));
}

TEST_CASE("a finding no worse and no more frequent than is accepted is accepted") {
  const CorpusCase known =
      accepted(wrong(kGross), {.because = "so", .up_to = 0.5, .per_million = {{"boxes", 10'000}}});
  const Finding as_before = found(known, kGross, 20, 0.5);
  CHECK(as_before.is_accepted);
  CHECK(as_before.objection.empty());
  CHECK_FALSE(as_before.is_new);
  CHECK(as_before.file == known.path);
  const Finding worse = found(known, kGross, 20, 0.6);
  CHECK_FALSE(worse.is_accepted);
  CHECK_THAT(worse.objection, Contains("worse than is accepted"));
  const Finding often = found(known, kGross, 100, 0.5);
  CHECK_FALSE(often.is_accepted);
  CHECK(often.objection == "more frequent than is accepted in boxes");
}

TEST_CASE("how often is too often is the ledger's budget, and none in regimes that did not run") {
  const auto with_rate = [](const std::string& regime) {
    return accepted(wrong(kGross), {.because = "so", .per_million = {{regime, 10'000}}});
  };
  // 10 of 1000 cases are expected; five standard deviations and five make 30.
  CHECK(found(with_rate("boxes"), kGross, 30, 0.5).is_accepted);
  CHECK_FALSE(found(with_rate("boxes"), kGross, 31, 0.5).is_accepted);
  CHECK(found(with_rate("sliver"), kGross, 1000, 0.5).is_accepted);
  CHECK(found(with_rate("generic"), kGross, 1000, 0.5).is_accepted);
}

TEST_CASE("past its day a finding is accepted no more, and is not new either") {
  const CorpusCase known = accepted(wrong(kGross), {.because = "so", .until = kToday});
  CHECK(found(known, kGross, 1, 0.5).is_accepted);
  const Finding past = found(known, kGross, 1, 0.5, "2026-11-24");
  CHECK_FALSE(past.is_accepted);
  CHECK_FALSE(past.is_new);
  CHECK_FALSE(past.objection.empty());
}

TEST_CASE("another bucket, class or subject is not what was accepted") {
  const Acceptance any{.because = "so"};
  CHECK_FALSE(found(accepted(wrong(kOlder + "/fine"), any), kGross, 1, 0.5).is_accepted);
  CHECK_FALSE(
      found(accepted(wrong("subject/subject_wrong/normal/none/a/gross"), any), kGross, 1, 0.5)
          .is_accepted);
  const Finding others = found(accepted(wrong(kGross, "another"), any), kGross, 1, 0.5);
  CHECK_FALSE(others.is_accepted);
  CHECK(others.is_new);
}

TEST_CASE("a file without a class knows and accepts its bucket in every class") {
  const CorpusCase older = accepted(wrong(kOlder), {.because = "so"});
  for (const char* error_class : {"/rounding", "/fine", "/gross"}) {
    const Finding finding = found(older, kOlder + error_class, 1, 0.5);
    CHECK(finding.is_accepted);
    CHECK(finding.file == older.path);
  }
  CHECK(is_bucket(kGross, kOlder));
  CHECK(is_bucket(kGross, kGross));
  CHECK(is_bucket(kGross, ""));
  CHECK_FALSE(is_bucket(kOlder, kGross));
  CHECK_FALSE(is_bucket(kGross, kOlder + "/fine"));
  CHECK_FALSE(is_bucket("subject/subject_wrong/depth/none/ab", kOlder));
}

TEST_CASE("of several acceptances of one finding the one that accepts most counts") {
  const Acceptance past{.because = "past", .until = "2026-01-01"};
  const Acceptance little{.because = "little", .up_to = 0.1};
  const Acceptance much{.because = "much", .up_to = 0.5};
  std::vector<CorpusCase> corpus{accepted(wrong(kGross), past), accepted(wrong(kGross), little),
                                 accepted(wrong(kGross), much)};
  const auto reason = [&] {
    return known_of(corpus, kToday).accepted.begin()->second.acceptance.because;
  };
  CHECK(reason() == "much");
  std::ranges::reverse(corpus);
  CHECK(reason() == "much");
}

TEST_CASE("the keys of the accepted share those of the known, and properties have their own") {
  CorpusCase of_property = wrong("");
  of_property.property = "never-empty";
  const CorpusCase corpus[] = {accepted(of_property, {.because = "so"}), wrong(kGross)};
  const Known known = known_of(corpus, kToday);
  CHECK(known.accepted.size() == 1);
  CHECK(known.accepted.contains(finding_key("never-empty", "mine")));
  CHECK_FALSE(known.accepted.contains(finding_key("never-empty", "another")));
  CHECK(known.files.contains(finding_key(*corpus[1].expect)));
}

TEST_CASE("accepted is stale once another bucket comes of those who were at fault") {
  const CorpusCase known = accepted(wrong(kGross), {.because = "so"});
  const Collider mine = named("mine");
  const Collider box2d = named("box2d");
  CHECK(is_stale(known, "none/agree/none/none/a", mine, box2d));
  CHECK(is_stale(known, kOlder + "/fine", mine, box2d));
  CHECK_FALSE(is_stale(known, kGross, mine, box2d));
  CHECK_FALSE(is_stale(known, "none/agree/none/none/a", named("another"), box2d));
  CHECK(is_stale(known, "none/agree/none/none/a", mine, named("chipmunk")));
  CHECK_FALSE(is_stale(wrong(kGross), "none/agree/none/none/a", mine, box2d));
  CHECK_FALSE(is_stale(accepted(wrong(kOlder), {.because = "so"}), kOlder + "/fine", mine, box2d));
}

TEST_CASE("a campaign waits for mistakes that nothing shows, or that are worse than accepted") {
  const CorpusCase shown = wrong(kGross);
  CHECK_FALSE(is_waited_for(kGross, 0.5, shown));
  CHECK(is_waited_for(kOlder + "/fine", 0.5, shown));
  const CorpusCase known = accepted(wrong(kGross), {.because = "so", .up_to = 0.5});
  CHECK_FALSE(is_waited_for(kGross, 0.5, known));
  CHECK(is_waited_for(kGross, 0.6, known));
  CHECK_FALSE(is_waited_for("none/tie/depth/none/a", 0.5, shown));
  CHECK(is_waited_for("none/tie/depth/none/a", 0.5, shown, true));
  CHECK_FALSE(is_waited_for("none/agree/none/none/a", 0, shown, true));
}

TEST_CASE("what a baseline has is not new, unless other colliders ran then") {
  CampaignResult baseline;
  baseline.settings.subject = "mine";
  baseline.settings.oracle = "box2d";
  baseline.buckets = {{.bucket = kGross}};
  const auto is_new = [&](const std::string& bucket) {
    const Plan plan = plan_of_boxes();
    Known known = known_of({}, kToday);
    add_baseline(baseline, plan, known);
    const bool is_waited_for =
        is_new_and_wrong({.bucket = *find_bucket(bucket), .magnitude = 0.5}, plan, known);
    CHECK(findings(tally_of(bucket, 1, 0.5), plan, known).front().is_new == is_waited_for);
    return is_waited_for;
  };
  CHECK_FALSE(is_new(kGross));
  CHECK(is_new(kOlder + "/fine"));
  baseline.settings.subject = "another";
  CHECK(is_new(kGross));
  baseline.settings.subject = "mine";
  baseline.settings.oracle = "chipmunk";
  CHECK(is_new(kGross));
}

TEST_CASE("what was seen counts each regime that ran, zeros too, and the fewest cases") {
  const Finding finding = found(wrong(kGross), kGross, 20, 0.5);
  const Seen seen = seen_of(finding, tally_of(kGross, 20, 0.5), plan_of_boxes());
  CHECK(seen.cases == 1000);
  CHECK(seen.magnitude == 0.5);
  CHECK(seen.regimes == std::map<std::string, std::uint64_t>{{"boxes", 20}, {"sliver", 0}});
}

TEST_CASE("an acceptance in words has all that it says, in one line") {
  CorpusCase known = accepted(wrong(kGross), {.because = "known\nsince 2.3",
                                              .link = "https://example.org",
                                              .until = "2026-01-31",
                                              .up_to = 0.125});
  CHECK(acceptance_in_words(known, "2026-01-31") ==
        "accepted " + known.path + ": " + kGross +
            " of mine, up to 0.125 of the size, until 2026-01-31: known\\x0asince 2.3 "
            "(https://example.org)");
  CHECK_THAT(acceptance_in_words(known, "2026-02-01"), Contains("until 2026-01-31, which is past"));
  known.property = "never-empty";
  CHECK_THAT(acceptance_in_words(known, "2026-01-31"), Contains(": property never-empty of mine"));
}
