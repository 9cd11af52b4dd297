#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/result.hpp"

namespace manifuzz {

bool holds_budgets(const Plan& plan) {
  return !plan.context.radius && plan.work->has_budgets();
}

bool is_over_budget(double per_million, std::string_view regime, std::uint64_t hits,
                    std::uint64_t cases) {
  if (regime == "corpus") return false;
  const double expected = per_million * 1e-6 * static_cast<double>(cases);
  return static_cast<double>(hits) > expected + 5 * std::sqrt(expected) + 5;
}

std::vector<LedgerResult> ledger_counts(const Tally& tally, const Plan& plan) {
  std::vector<LedgerResult> counts;
  for (const LedgerEntry& entry : ledger()) {
    if (entry.collider != plan.oracle.declaration.name) continue;
    LedgerResult count{std::string(entry.id), 0, {}, {}};
    for (std::size_t r = 0; r < plan.regimes.size(); ++r) {
      const std::uint64_t hits = tally.explained[index_of(entry)][r];
      count.hits += hits;
      const std::string regime(plan.regimes[r]->name);
      if (hits > 0) count.regimes[regime] = hits;
      const double budget = budget_per_million(entry, regime);
      if (holds_budgets(plan) && is_over_budget(budget, regime, hits, tally.regimes[r].cases)) {
        count.over_budget.push_back(regime);
      }
    }
    counts.push_back(count);
  }
  return counts;
}

namespace {

constexpr double kWorseFrom = 1.1;

struct Part {
  std::string_view name;
  std::vector<std::string> BucketComparison::*buckets;
};
constexpr std::array kParts{
    Part{"new", &BucketComparison::appeared}, Part{"worse", &BucketComparison::worse},
    Part{"still", &BucketComparison::still}, Part{"gone", &BucketComparison::gone}};

/// That in which runs must not differ if they are to be compared, by its name.
std::vector<std::pair<std::string_view, std::string>> terms_of(const CampaignResult& result) {
  const auto seed = result.seed();
  return {{"subject", result.settings.subject},
          {"oracle", result.settings.oracle},
          {"seed", seed ? std::to_string(*seed) : "several"},
          {"first", std::to_string(result.first())},
          {"cases", std::to_string(result.cases())}};
}

}  // namespace

CampaignResult read_baseline(const std::string& path) {
  try {
    const ResultFile result = read_result(path);
    if (result.campaign) return *result.campaign;
    throw UserError(fmt::format("{}: is a result of {}; one of fuzz is expected",
                                printable(path, 200), result.kind));
  } catch (const UserError& error) {
    throw UserError(fmt::format("--baseline: {}", error.what()));
  }
}

bool is_of(const Settings& settings, const std::string& subject, const std::string& oracle) {
  return settings.subject == subject && settings.oracle == oracle;
}

std::string differences_in_words(const CampaignResult& earlier, const CampaignResult& now) {
  std::vector<std::string> differences;
  const auto before = terms_of(earlier);
  const auto after = terms_of(now);
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto& [name, value] = after[i];
    if (before[i] == after[i]) continue;
    differences.push_back(fmt::format("{} ({}, now {})", name, before[i].second, value));
  }
  const bool same_regimes = std::ranges::equal(earlier.regimes, now.regimes, {},
                                               &RegimeResult::name, &RegimeResult::name);
  if (!same_regimes) differences.emplace_back("regimes");
  if (differences.empty()) return "";
  return fmt::format("the baseline differs in {}: what is new or gone may be due to that\n",
                     fmt::join(differences, ", "));
}

BucketComparison compared(const CampaignResult& earlier, const CampaignResult& now) {
  BucketComparison comparison;
  for (const BucketResult& found : now.buckets) {
    const auto before = std::ranges::find(earlier.buckets, found.bucket, &BucketResult::bucket);
    if (before == earlier.buckets.end()) {
      comparison.appeared.push_back(found.bucket);
    } else if (found.error.magnitude > kWorseFrom * before->error.magnitude) {
      comparison.worse.push_back(found.bucket);
    } else {
      comparison.still.push_back(found.bucket);
    }
  }
  for (const BucketResult& before : earlier.buckets) {
    const auto again = std::ranges::find(now.buckets, before.bucket, &BucketResult::bucket);
    if (again == now.buckets.end()) comparison.gone.push_back(before.bucket);
  }
  return comparison;
}

void hold_against(const CampaignResult& earlier, CampaignResult& now) {
  if (!is_of(earlier.settings, now.settings.subject, now.settings.oracle)) return;
  const BucketComparison comparison = compared(earlier, now);
  for (BucketResult& found : now.buckets) {
    found.is_in_baseline = !found.is_new && std::ranges::count(comparison.worse, found.bucket) == 0;
  }
}

std::string comparison_text(const CampaignResult& earlier, const CampaignResult& now) {
  const BucketComparison comparison = compared(earlier, now);
  std::string text = differences_in_words(earlier, now) + "against the baseline\n";
  for (const Part& part : kParts) {
    const auto& buckets = comparison.*part.buckets;
    text += fmt::format("{:<18}{:>14}\n", part.name, buckets.size());
    if (part.name == "still") continue;
    for (const std::string& bucket : buckets) text += fmt::format("  {}\n", bucket);
  }
  return text;
}

std::string comparison_line(const CampaignResult& earlier, const CampaignResult& now) {
  const BucketComparison comparison = compared(earlier, now);
  std::vector<std::string> counts;
  for (const Part& part : kParts) {
    counts.push_back(fmt::format("{} {}", (comparison.*part.buckets).size(), part.name));
  }
  std::string line = fmt::format("buckets against the baseline: {}", fmt::join(counts, ", "));
  const std::string differences = differences_in_words(earlier, now);
  if (!differences.empty()) line += "; " + differences.substr(0, differences.size() - 1);
  return line;
}

nlohmann::ordered_json comparison_json(const BucketComparison& comparison) {
  nlohmann::ordered_json json;
  for (const Part& part : kParts) json[std::string(part.name)] = comparison.*part.buckets;
  return json;
}

}  // namespace manifuzz
