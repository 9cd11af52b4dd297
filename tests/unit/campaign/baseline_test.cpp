#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "campaign/result.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;

namespace {

using Names = std::vector<std::string>;

/// A run that met these buckets, each so badly.
CampaignResult run_with(const std::vector<std::pair<std::string, double>>& magnitudes) {
  CampaignResult run;
  run.parts = {{.seed = 1, .cases = {{"boxes", 10}}}};
  run.settings.oracle = "box2d";
  run.regimes = {{{10, 1, 0, 0}, "boxes"}};
  for (const auto& [bucket, magnitude] : magnitudes) {
    run.buckets.push_back({.bucket = bucket, .verdict = "tie", .error = {magnitude}});
  }
  return run;
}

}  // namespace

TEST_CASE("a run against an earlier one: what is new, worse, still there, gone") {
  const BucketComparison comparison =
      compared(run_with({{"depth", 0.1}, {"count", 0.1}, {"features", 0}}),
               run_with({{"normal", 0.1}, {"depth", 0.1}, {"count", 0.2}}));
  CHECK(comparison.appeared == Names{"normal"});
  CHECK(comparison.still == Names{"depth"});
  CHECK(comparison.worse == Names{"count"});
  CHECK(comparison.gone == Names{"features"});
  CHECK(comparison_json(comparison)["new"].size() == 1);
}

TEST_CASE("what two runs do not share is said") {
  const CampaignResult one = run_with({});
  CampaignResult other = one;
  CHECK(differences_in_words(one, other).empty());
  other.parts[0].seed = 2;
  other.regimes[0].name = "grid";
  CHECK(differences_in_words(one, other)
            .starts_with("the baseline differs in seed (1, now 2), regimes:"));
  CHECK(comparison_text(one, other).find("differs in seed") != std::string::npos);
}

TEST_CASE("a baseline is what fuzz --json wrote, and nothing else") {
  const test::TemporaryFolder folder;
  CampaignResult run = run_with({{"depth", 0.1}});
  run.verdicts[0] = 10;
  const nlohmann::ordered_json good = json_of(run);
  CHECK(read_baseline(folder.write("good.json", good.dump())).buckets.size() == 1);
  const auto refused = [&](const std::string& text) {
    CHECK_THROWS_AS(read_baseline(folder.write("bad.json", text)), UserError);
  };
  for (const auto* text : {"", "[]", "{}", "null", "{\"machine\": {}, \"failures\": []}"}) {
    refused(text);
  }
  refused("{\"machine\":" + std::string(200000, '[') + std::string(200000, ']') +
          ",\"buckets\":[]}");
  CHECK_THROWS_AS(read_baseline("no-such-file"), UserError);
}
