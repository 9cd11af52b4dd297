#include "campaign/risk/risk.hpp"

#include <array>

#include <catch2/catch.hpp>

#include "campaign/result.hpp"
#include "campaign/risk/curve.hpp"
#include "generating/regime.hpp"

using namespace manifuzz;

namespace {

const char* const kTieMet = "none/tie/none/none/a";
const char* const kKnownMet = "oracle/known/depth/none/a";
const char* const kWrongMet = "subject/subject_wrong/depth/none/a/gross";

/// Two regimes and the corpus, of whose agreed contacts some are judged.
CampaignResult counted_result() {
  CampaignResult result;
  result.risk_error = kRiskError;
  result.regimes = {{{100, 0, 0, 0, 0, 40, 4}, "boxes"},
                    {{200, 0, 0, 0, 0, 60, 6}, "grid"},
                    {{300, 0, 0, 0, 0, 10, 1}, "corpus"}};
  result.parts = {{7, 5, {{"boxes", 100}, {"grid", 100}, {"corpus", 100}}, 1}};
  const auto add = [&](const char* bucket, std::map<std::string, std::uint64_t> counts,
                       std::map<std::string, std::uint64_t> agreed) {
    BucketResult& found = result.buckets.emplace_back();
    found.bucket = bucket;
    found.regimes = std::move(counts);
    found.agreed = std::move(agreed);
    found.seed = 7;
  };
  add(kTieMet, {{"boxes", 1}, {"grid", 1}, {"corpus", 50}}, {});
  add(kKnownMet, {{"grid", 1}}, {});
  add(kWrongMet, {{"boxes", 1}, {"corpus", 1}}, {{"boxes", 1}});
  return result;
}

void check_row(const RiskRow& row, const std::string& regime, std::uint64_t cases,
               std::uint64_t once, std::uint64_t wrong_once) {
  CHECK(row.regime == regime);
  CHECK(row.cases == cases);
  CHECK(row.any.once == once);
  CHECK(row.wrong.once == wrong_once);
}

}  // namespace

TEST_CASE("a row counts its own buckets, that of all those met anywhere, and none the corpus") {
  const std::vector<RiskRow> rows = risk_of(counted_result());
  REQUIRE(rows.size() == 3);
  check_row(rows[0], "boxes", 100, 2, 1);
  check_row(rows[1], "grid", 200, 2, 1);
  check_row(rows[2], "all", 300, 2, 2);
  // Among boxes, one of the 60 cases that are always judged, and one of 4 in the other 40.
  CHECK(rows[0].any.next == Approx(0.6 * 1 / 60 + 0.4 * 1 / 4));
  CHECK(rows[0].wrong.next == Approx(0.4 * 1 / 4));
  // The tie was met twice, each time where all are judged.
  const std::array all{Stratum{200, 200, 1, 1}, Stratum{100, 10, 1, 0}};
  CHECK(rows[2].any.high == chance_of_unseen(all, kRiskError).high);
  const std::array wrong{Stratum{200, 200, 1, 0}, Stratum{100, 10, 1, 0}};
  CHECK(rows[2].wrong.high == chance_of_unseen(wrong, kRiskError).high);
}

TEST_CASE("there is no risk where it was not counted, and none of the corpus alone") {
  CampaignResult result = counted_result();
  result.risk_error.reset();
  CHECK(risk_of(result).empty());
  result = counted_result();
  result.regimes = {result.regimes[2]};
  CHECK(risk_of(result).empty());
}

TEST_CASE("a run's own tally gives the row of all that its result gives") {
  const CampaignResult result = counted_result();
  Plan plan;
  auto tally = std::make_unique<Tally>();
  for (std::size_t r = 0; r < result.regimes.size(); ++r) {
    plan.regimes.push_back(find_regime(result.regimes[r].name));
    tally->regimes[r] = result.regimes[r];
    for (const BucketResult& found : result.buckets) {
      BucketTally& met = tally->buckets.of(*find_bucket(found.bucket));
      const auto count = found.regimes.find(result.regimes[r].name);
      const auto agreed = found.agreed.find(result.regimes[r].name);
      if (count != found.regimes.end()) met.regimes[r] = count->second;
      if (agreed != found.agreed.end()) met.agreed[r] = agreed->second;
    }
  }
  const RiskRow all = risk_of_all(*tally, plan, kRiskError);
  const RiskRow same = risk_of(result).back();
  check_row(all, "all", same.cases, same.any.once, same.wrong.once);
  CHECK(all.any.high == same.any.high);
  CHECK(all.wrong.low == same.wrong.low);
}

TEST_CASE("the curve has a point at each case that showed a bucket first, and one at the end") {
  CampaignResult result = counted_result();
  const auto set_first = [&](std::size_t i, std::uint64_t index, const char* regime) {
    result.buckets[i].first_index = index;
    result.buckets[i].regime = regime;
  };
  set_first(0, 5, "boxes");
  set_first(1, 7, "grid");
  set_first(2, 5, "corpus");
  const std::vector<CurvePoint> curve = bucket_curve(result);
  CHECK(curve == std::vector<CurvePoint>{{1, 1, 0}, {3, 2, 1}, {8, 3, 2}, {600, 3, 2}});
}

TEST_CASE("several seeds are one campaign on the curve, by index, regime and seed") {
  CampaignResult result = counted_result();
  result.regimes.pop_back();
  result.parts = {{1, 0, {{"boxes", 10}, {"grid", 10}}, 1},
                  {2, 5, {{"boxes", 10}, {"grid", 10}}, 1}};
  result.buckets.resize(2);
  result.buckets[0] = {.bucket = kTieMet, .seed = 2, .first_index = 5, .regime = "boxes"};
  result.buckets[1] = {.bucket = kKnownMet, .seed = 1, .first_index = 6, .regime = "grid"};
  // Five indices of one seed, two regimes each; then boxes of seed 1 and of seed 2.
  const std::vector<CurvePoint> curve = bucket_curve(result);
  CHECK(curve[0] == CurvePoint{12, 1, 0});
  CHECK(curve[1] == CurvePoint{10 + 4 + 3, 2, 1});
}
