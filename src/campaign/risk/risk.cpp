#include "campaign/risk/risk.hpp"

#include <algorithm>
#include <array>

#include "campaign/plan.hpp"
#include "campaign/result.hpp"

namespace manifuzz {
namespace {

/// Buckets that a row's cases show once and twice: by cases that are always judged, and by the
/// sample of agreed contacts.
struct MetFew {
  std::array<std::uint64_t, 2> once{};
  std::array<std::uint64_t, 2> twice{};

  /// A bucket with so many cases, `agreed` of them of the sample.
  void meet(std::uint64_t count, std::uint64_t agreed) {
    if (count == 1) ++once[agreed];
    // One in each part says nothing of either alone.
    if (count == 2 && agreed != 1) ++twice[agreed / 2];
  }
};

struct RowCounts {
  RegimeTally cases{};
  MetFew any{};
  MetFew wrong{};

  void meet(std::uint64_t count, std::uint64_t agreed, bool is_wrong) {
    any.meet(count, agreed);
    if (is_wrong) wrong.meet(count, agreed);
  }
};

UnseenRisk unseen_risk(const RegimeTally& of, const MetFew& met, double error) {
  const std::uint64_t always = of.cases - std::min(of.cases, of.agreed);
  const std::array strata{Stratum{always, always, met.once[0], met.twice[0]},
                          Stratum{of.agreed, of.agreed_judged, met.once[1], met.twice[1]}};
  return {chance_of_unseen(strata, error), met.once[0] + met.once[1]};
}

RiskRow row_of(std::string_view name, const RowCounts& counts, double error) {
  return {std::string(name), counts.cases.cases, unseen_risk(counts.cases, counts.any, error),
          unseen_risk(counts.cases, counts.wrong, error)};
}

std::uint64_t count_in(const std::map<std::string, std::uint64_t>& counts,
                       const std::string& regime) {
  const auto count = counts.find(regime);
  return count == counts.end() ? 0 : count->second;
}

struct RowOfRegime {
  std::string name;
  RowCounts counts;
};

/// What is met in each regime that has a risk; `all` gets it of all together.
std::vector<RowOfRegime> count_rows(const CampaignResult& result, RowCounts& all) {
  std::vector<RowOfRegime> rows;
  for (const RegimeResult& regime : result.regimes) {
    if (has_no_risk(regime.name)) continue;
    rows.push_back({regime.name, {.cases = regime}});
    all.cases.add(regime);
  }
  for (const BucketResult& found : result.buckets) {
    const bool is_wrong = is_of_fault(found.bucket);
    std::uint64_t count = 0;
    std::uint64_t agreed = 0;
    for (auto& [name, counts] : rows) {
      const std::uint64_t count_here = count_in(found.regimes, name);
      const std::uint64_t agreed_here = std::min(count_here, count_in(found.agreed, name));
      counts.meet(count_here, agreed_here, is_wrong);
      count += count_here;
      agreed += agreed_here;
    }
    all.meet(count, agreed, is_wrong);
  }
  return rows;
}

}  // namespace

double error_of_look(std::uint64_t look) {
  const auto k = static_cast<double>(look);
  return kRiskError / (k * (k + 1));
}

bool is_of_fault(const std::string& bucket) {
  const auto known = find_bucket(bucket);
  return !known || known->fault != Fault::none;
}

bool has_no_risk(std::string_view regime) {
  return regime == "corpus";
}

void expect_risk(const Plan& plan) {
  const bool has_risk = std::ranges::any_of(
      plan.regimes, [](const Regime* regime) { return !has_no_risk(regime->name); });
  if (!plan.until_risk || has_risk) return;
  throw UserError(
      "--until-risk: what the regime corpus can show depends on the corpus, so it has no risk; add "
      "another --regime");
}

std::vector<RiskRow> risk_of(const CampaignResult& result) {
  if (!result.risk_error) return {};
  RowCounts all;
  const std::vector<RowOfRegime> rows = count_rows(result, all);
  if (rows.empty()) return {};
  std::vector<RiskRow> risk;
  for (const auto& [name, counts] : rows) risk.push_back(row_of(name, counts, *result.risk_error));
  risk.push_back(row_of(kAllRegimes, all, *result.risk_error));
  return risk;
}

RiskRow risk_of_all(const Tally& tally, const Plan& plan, double error) {
  RowCounts all;
  const auto sum_over_regimes = [&plan](const auto& add) {
    for (std::size_t r = 0; r < plan.regimes.size(); ++r) {
      if (!has_no_risk(plan.regimes[r]->name)) add(r);
    }
  };
  sum_over_regimes([&](std::size_t r) { all.cases.add(tally.regimes[r]); });
  for (const auto& [bucket, met] : tally.buckets.all()) {
    std::uint64_t count = 0;
    std::uint64_t agreed = 0;
    sum_over_regimes([&, of = met](std::size_t r) {
      count += of->regimes[r];
      agreed += of->agreed[r];
    });
    all.meet(count, agreed, bucket.fault != Fault::none);
  }
  return row_of(kAllRegimes, all, error);
}

}  // namespace manifuzz
