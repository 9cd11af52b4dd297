#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <thread>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "campaign/run.hpp"
#include "engines/colliders.hpp"

using namespace manifuzz;

namespace {

/// A variable of the environment, or what it is without.
std::uint64_t number_from(const char* name, std::uint64_t usual) {
  const char* const text = std::getenv(name);
  return text == nullptr ? usual : std::strtoull(text, nullptr, 10);
}

std::string name_from(const char* name, const char* usual) {
  const char* const text = std::getenv(name);
  return text == nullptr ? usual : text;
}

/// A row's cases, and how often they showed each bucket: always judged, and as agreed contacts.
struct RowMet {
  RegimeTally cases;
  std::map<std::string, std::array<std::uint64_t, 2>> buckets;

  void add(const RowMet& other) {
    cases.add(other.cases);
    for (const auto& [bucket, met] : other.buckets) {
      buckets[bucket][0] += met[0];
      buckets[bucket][1] += met[1];
    }
  }
};
using Rows = std::map<std::string, RowMet>;

Rows rows_of(const CampaignResult& result) {
  Rows rows;
  for (const RegimeResult& regime : result.regimes) rows[regime.name].cases = regime;
  for (const BucketResult& found : result.buckets) {
    for (const auto& [regime, count] : found.regimes) {
      const auto agreed = found.agreed.find(regime);
      const std::uint64_t sampled = agreed == found.agreed.end() ? 0 : agreed->second;
      rows[regime].buckets[found.bucket] = {count - sampled, sampled};
    }
  }
  RowMet all;
  for (const auto& [regime, row] : rows) all.add(row);
  rows[std::string(kAllRegimes)] = all;
  return rows;
}

struct Piece {
  Rows rows;
  std::vector<RiskRow> risk;
};

/// Whether the share of a row's unseen buckets among the cases of all other pieces lies within the
/// interval, widened by what chance makes of that share.
bool holds_for_others(const RowMet& piece, const RowMet& whole, const UnseenRisk& risk,
                      bool only_wrong) {
  const auto cases = static_cast<double>(whole.cases.cases - piece.cases.cases);
  const auto judged = static_cast<double>(whole.cases.agreed_judged - piece.cases.agreed_judged);
  const auto agreed = static_cast<double>(whole.cases.agreed - piece.cases.agreed);
  const double weight = judged > 0 ? agreed / judged : 0;
  double unseen = 0;
  double variance = 0;
  for (const auto& [bucket, met] : whole.buckets) {
    if (piece.buckets.contains(bucket) || (only_wrong && !is_of_fault(bucket))) continue;
    unseen += static_cast<double>(met[0]) + weight * static_cast<double>(met[1]);
    variance += static_cast<double>(met[0]) + weight * weight * static_cast<double>(met[1]);
  }
  const double error = 1.96 * std::sqrt(variance) / cases;
  return risk.low - error <= unseen / cases && unseen / cases <= risk.high + error;
}

struct Held {
  std::uint64_t held = 0;
  std::uint64_t all = 0;
  double once = 0;
  double high = 0;

  void add(bool holds, const UnseenRisk& risk) {
    held += holds ? 1 : 0;
    ++all;
    once += static_cast<double>(risk.once);
    high += risk.high;
  }
  double share() const { return static_cast<double>(held) / static_cast<double>(all); }
};

Plan plan_of_pieces() {
  Plan plan;
  plan.subject = find_collider(name_from("MANIFUZZ_SUBJECT", "box2d"));
  plan.oracle = find_collider(name_from("MANIFUZZ_ORACLE", "chipmunk"));
  plan.regimes = regimes_for({plan.subject, plan.oracle}, {});
  std::erase_if(plan.regimes, [](const Regime* regime) { return has_no_risk(regime->name); });
  narrow_to_colliders(plan);
  plan.seed = number_from("MANIFUZZ_SEED", 1);
  plan.judge_every = number_from("MANIFUZZ_JUDGE_EVERY", kJudgeEvery);
  plan.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return plan;
}

}  // namespace

// It takes ten minutes; src/campaign/README.md has what it printed.
TEST_CASE("the intervals of many pieces of one campaign hold for its other cases", "[.pieces]") {
  const std::uint64_t pieces = number_from("MANIFUZZ_PIECES", 2000);
  const std::uint64_t cases = number_from("MANIFUZZ_PIECE", 5000);
  Plan plan = plan_of_pieces();
  const std::uint64_t turns = (cases + plan.regimes.size() - 1) / plan.regimes.size();
  Origin origin;
  origin.provenance = {{"machine", nlohmann::ordered_json::object()},
                       {"compiler", ""},
                       {"versions", nlohmann::ordered_json::object()}};
  std::vector<Piece> all;
  Rows whole;
  for (std::uint64_t i = 0; i < pieces; ++i) {
    plan.first = i * turns;
    plan.cases = cases;
    const Campaign campaign = run_campaign(plan, {}, {}, origin, [](const Progress&) {});
    REQUIRE(campaign.result.cases() == cases);
    all.push_back({rows_of(campaign.result), risk_of(campaign.result)});
    for (const auto& [name, row] : all.back().rows) whole[name].add(row);
  }
  std::map<std::string, std::array<Held, 2>> held;
  for (const Piece& piece : all) {
    for (const RiskRow& risk : piece.risk) {
      const RowMet& row = piece.rows.at(risk.regime);
      held[risk.regime][0].add(holds_for_others(row, whole[risk.regime], risk.any, false),
                               risk.any);
      held[risk.regime][1].add(holds_for_others(row, whole[risk.regime], risk.wrong, true),
                               risk.wrong);
    }
  }
  for (const auto& [name, both] : held) {
    const auto mean = [&](double sum) { return sum / static_cast<double>(pieces); };
    fmt::print(
        "{:<18} any {:.4f} (once {:.2f}, high {:.2g})  wrong {:.4f} (once {:.2f}, high {:.2g})\n",
        name, both[0].share(), mean(both[0].once), mean(both[0].high), both[1].share(),
        mean(both[1].once), mean(both[1].high));
    CAPTURE(name);
    for (const Held& of : both) CHECK(of.share() >= 0.94);
  }
}
