#include "report/risk_text.hpp"

#include <fmt/format.h>

#include "campaign/result.hpp"
#include "report/rows.hpp"

namespace manifuzz {
namespace {

/// Whole from 10 on, else two digits.
std::string in_a_million(double chance) {
  const double million = 1e6 * chance;
  return million >= 9.95 ? fmt::format("{:.0f}", million) : fmt::format("{:.2g}", million);
}

std::string interval_in_words(const Chance& chance) {
  return fmt::format("{} to {}", in_a_million(chance.low), in_a_million(chance.high));
}

}  // namespace

std::string risk_in_words(const CampaignResult& result) {
  const std::vector<RiskRow> rows = risk_of(result);
  if (rows.empty()) return "";
  const RiskRow& all = rows.back();
  return fmt::format(
      "a bucket not yet seen: {} in a million further cases (95% interval: {}); a wrong one: {} "
      "({})",
      in_a_million(all.any.next), interval_in_words(all.any), in_a_million(all.wrong.next),
      interval_in_words(all.wrong));
}

std::string risk_rows(const CampaignResult& result) {
  const std::vector<RiskRow> rows = risk_of(result);
  if (rows.empty()) return "";
  static constexpr std::string_view row = "{:<18}{:>14}{:>6}{:>9}{:>18}{:>12}{:>9}{:>18}\n";
  return "buckets not yet seen, in a million further cases, with 95% intervals; met once: buckets "
         "with one case\n" +
         fmt::format(row, "regime", "cases", "once", "next", "interval", "wrong once", "next",
                     "interval") +
         lines_of(rows, [](const RiskRow& of) {
           return fmt::format(row, of.regime, of.cases, of.any.once, in_a_million(of.any.next),
                              interval_in_words(of.any), of.wrong.once, in_a_million(of.wrong.next),
                              interval_in_words(of.wrong));
         });
}

std::string end_by_risk_in_words(const Campaign& campaign) {
  const CampaignResult& result = campaign.result;
  const std::vector<RiskRow> rows = risk_of(result);
  if (result.ended_by.empty() || rows.empty()) return "";
  const std::string risk =
      fmt::format("the risk is at most {} in a million after {} {}",
                  in_a_million(rows.back().any.high), result.cases(), campaign.plan.work->noun());
  if (result.ended_by == "risk") return fmt::format("ended by --until-risk: {}\n", risk);
  const bool is_limit = result.ended_by == "cases" || result.ended_by == "seconds";
  return fmt::format("ended by {}{}, before --until-risk: {}\n", is_limit ? "--" : "",
                     result.ended_by, risk);
}

}  // namespace manifuzz
