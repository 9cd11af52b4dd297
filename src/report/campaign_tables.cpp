#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/result.hpp"
#include "report/campaign_text.hpp"
#include "report/outputs.hpp"
#include "report/risk_text.hpp"
#include "report/rows.hpp"
#include "report/sequence/sequence_report.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "-";
  return fmt::format("{:.1f}%", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string regime_rows(const CampaignResult& result) {
  static constexpr std::string_view row = "{:<18}{:>14}{:>10}{:>8}{:>13}\n";
  const std::string heading =
      fmt::format(row, "regime", "cases", "touching", "near", "unexplained");
  return heading + lines_of(result.regimes, [](const RegimeResult& regime) {
           return fmt::format(row, regime.name, regime.cases,
                              percent(regime.touching, regime.cases),
                              percent(regime.near, regime.cases), regime.unexplained);
         });
}

std::string verdict_rows(const CampaignResult& result) {
  std::string text;
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    const std::string name = fmt::format("{:<18}", kVerdictNames[i]);
    const bool is_bad = result.verdicts[i] > 0 && is_unexplained(static_cast<Verdict>(i));
    text += fmt::format("{}{:>14}\n", is_bad ? bad(name) : name, result.verdicts[i]);
  }
  text += fmt::format("{:<18}{:>14}\n", "unexplained", result.unexplained());
  text += fmt::format("{:<18}{:>14}  of those that agree\n", "judged", result.agreeing_judged);
  if (result.accepted() > 0) text += fmt::format("{:<18}{:>14}\n", "accepted", result.accepted());
  if (result.by_tolerance > 0) {
    text += fmt::format("{:<18}{:>14}\n", "by tolerance", result.by_tolerance);
  }
  for (const std::string& allowance : result.settings.allowances) {
    text += fmt::format("{}\n", printable(allowance, 400));
  }
  return text;
}

std::string ledger_rows(const CampaignResult& result) {
  return lines_of(result.ledger, [](const LedgerResult& entry) {
    return fmt::format("{:<36}{:>14}{}\n", entry.id, entry.hits,
                       entry.hits == 0 ? "  never fired" : "");
  });
}

std::string hint_line(const Hint& hint) {
  return fmt::format("{}: {}\n", fresh("hint"), hint.text);
}

std::string over_budget_lines(const CampaignResult& result) {
  return lines_of(result.ledger, [](const LedgerResult& entry) {
    if (entry.over_budget.empty()) return std::string();
    return fmt::format(
        "{}: {}\n", entry.id,
        bad(fmt::format("over its budget in {}", fmt::join(entry.over_budget, ", "))));
  });
}

/// What became of the run as a whole, where it is not what was asked for.
std::string state_in_words(const Campaign& campaign) {
  std::string text;
  if (is_all_unsupported(campaign.result)) {
    text += fmt::format(
        "vacuous: {} or {} takes none of these cases, so nothing was shown; choose other regimes "
        "or colliders\n",
        campaign.result.settings.subject, campaign.result.settings.oracle);
  } else if (is_vacuous(campaign.result)) {
    text += "vacuous: nothing touched, so nothing was shown; choose other regimes or a radius\n";
  }
  if (campaign.result.stopped_early) {
    const bool is_subject = campaign.run.given_up == Fault::subject;
    text +=
        fmt::format("stopped early: {} gave no answer again and again: {}\n",
                    is_subject ? campaign.result.settings.subject : campaign.result.settings.oracle,
                    printable(campaign.run.why_given_up, 200));
  }
  if (campaign.saving.as_seen > 0) {
    text += fmt::format(
        "{} of the new findings are saved as they were seen: asked again, {} or {} gave no answer "
        "in time\n",
        campaign.saving.as_seen, campaign.result.settings.subject, campaign.result.settings.oracle);
  }
  if (!campaign.result.interrupted) return text;
  const std::size_t unsaved = campaign.saving.unsaved;
  text += "interrupted: what was found until then is counted";
  return text + (unsaved == 0 ? " and kept\n"
                              : fmt::format(", but {} {} not saved\n", counted(unsaved, "finding"),
                                            unsaved == 1 ? "is" : "are"));
}

std::string bucket_rows(const BucketResult& found) {
  const bool is_bad = decides_status(found);
  const std::string how = found.is_new ? fresh("new ") : found.is_accepted ? "accepted " : "";
  std::string text = fmt::format("{}{}: {}, worst {:.2g} of the size\n", how,
                                 is_bad ? bad(found.bucket) : found.bucket,
                                 times_in_words(found.count), found.error.magnitude);
  if (!found.objection.empty()) text += fmt::format("  {}\n", bad(found.objection));
  if (!found.file.empty()) text += fmt::format("  {}\n", found.file);
  const auto bucket = find_bucket(found.bucket);
  const bool is_open = found.is_new || (bucket && is_unexplained(bucket->verdict));
  return is_open && !found.is_accepted ? text + fmt::format("  {}\n", found.command) : text;
}

std::string case_heading(const Campaign& campaign) {
  const CampaignResult& result = campaign.result;
  return fmt::format("{} against {} {}: {} in {:.1f} s ({:.0f} a second, {}), seed {}\n",
                     result.settings.subject, result.settings.oracle,
                     campaign.plan.oracle.declaration.version, counted(result.cases(), "case"),
                     result.seconds(), per_second(result.cases(), result.seconds()),
                     counted(result.jobs, "job"), campaign.plan.seed);
}

std::string unshrunk_in_words(const CampaignResult& result) {
  if (result.unshrunk == 0) return "";
  return fmt::format(
      "{} of the new findings are not as small as can be, for there was no more time: manifuzz "
      "shrink DIR goes on\n",
      result.unshrunk);
}

}  // namespace

double per_second(std::uint64_t cases, double seconds) {
  return seconds > 0 ? static_cast<double>(cases) / seconds : 0;
}

std::string campaign_heading(const Campaign& campaign) {
  return campaign.result.has_frames() ? sequence_heading(campaign.result, campaign.plan.seed)
                                      : case_heading(campaign);
}

std::string remarks_on_campaign(const Campaign& campaign) {
  std::string text = state_in_words(campaign) + end_by_risk_in_words(campaign) +
                     lines_of(campaign.result.hints, hint_line) +
                     over_budget_lines(campaign.result);
  if (campaign.plan.until_new && !campaign.run.sought && !has_new(campaign.findings)) {
    text += "nothing new: the corpus shows each of these already\n";
  }
  return text + unshrunk_in_words(campaign.result);
}

std::string summary_table(const Campaign& campaign, const std::optional<CampaignResult>& baseline) {
  const CampaignResult& result = campaign.result;
  std::string text = fmt::format("{}\n{}", campaign_heading(campaign),
                                 result.has_frames() ? motion_rows(result) : regime_rows(result));
  text += '\n' + verdict_rows(result);
  if (const std::string risk = risk_rows(result); !risk.empty()) text += '\n' + risk;
  if (!result.ledger.empty()) text += '\n' + ledger_rows(result);
  if (!result.buckets.empty()) text += '\n';
  text += lines_of(result.buckets, bucket_rows);
  const std::string remarks = remarks_on_campaign(campaign) + stale_in_words(result.stale);
  if (!remarks.empty()) text += '\n' + remarks;
  if (baseline) text += '\n' + comparison_text(*baseline, campaign.result);
  return text;
}

std::string objections(const Campaign& campaign) {
  std::string text;
  for (const BucketResult& found : campaign.result.buckets) {
    if (decides_status(found)) text += bucket_rows(found);
  }
  return text + over_budget_lines(campaign.result) + state_in_words(campaign);
}

}  // namespace manifuzz
