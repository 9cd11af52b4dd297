#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/result.hpp"
#include "generating/sweep.hpp"
#include "measure/scene/scene_run.hpp"
#include "report/outputs.hpp"
#include "report/sequence/sequence_report.hpp"

namespace manifuzz {
namespace {

/// What `line_of` says of each, one after the other.
std::string lines_of(const auto& list, const auto& line_of) {
  std::string lines;
  for (const auto& one : list) lines += line_of(one);
  return lines;
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "-";
  return fmt::format("{:.1f}%", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

double rate(std::uint64_t cases, double seconds) {
  return seconds > 0 ? static_cast<double>(cases) / seconds : 0;
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

std::string over_budget_in_words(const LedgerResult& entry) {
  if (entry.over_budget.empty()) return "";
  return fmt::format("  {}\n",
                     bad(fmt::format("over its budget in {}", fmt::join(entry.over_budget, ", "))));
}

std::string ledger_rows(const CampaignResult& result) {
  return lines_of(result.ledger, [](const LedgerResult& entry) {
    return fmt::format("{:<36}{:>14}{}\n{}", entry.id, entry.hits,
                       entry.hits == 0 ? "  never fired" : "", over_budget_in_words(entry));
  });
}

/// What became of the run as a whole, where it is not what was asked for.
std::string state_in_words(const Campaign& campaign) {
  std::string text;
  if (is_all_unsupported(campaign.result)) {
    text += fmt::format(
        "\nvacuous: {} or {} takes none of these cases, so nothing was shown; choose other regimes "
        "or colliders\n",
        campaign.result.settings.subject, campaign.result.settings.oracle);
  } else if (is_vacuous(campaign.result)) {
    text += "\nvacuous: nothing touched, so nothing was shown; choose other regimes or a radius\n";
  }
  if (campaign.result.stopped_early) {
    const bool is_subject = campaign.run.given_up == Fault::subject;
    text +=
        fmt::format("\nstopped early: {} gave no answer again and again: {}\n",
                    is_subject ? campaign.result.settings.subject : campaign.result.settings.oracle,
                    printable(campaign.run.why_given_up, 200));
  }
  if (campaign.saving.as_seen > 0) {
    text += fmt::format(
        "\n{} of the new findings are saved as they were seen: asked again, {} or {} gave no "
        "answer "
        "in time\n",
        campaign.saving.as_seen, campaign.result.settings.subject, campaign.result.settings.oracle);
  }
  if (!campaign.result.interrupted) return text;
  const std::size_t unsaved = campaign.saving.unsaved;
  text += "\ninterrupted: what was found until then is counted";
  return text +
         (unsaved == 0 ? " and kept\n" : fmt::format(", but {} findings are not saved\n", unsaved));
}

std::string bucket_rows(const BucketResult& found) {
  const bool is_bad = decides_status(found);
  const std::string how = found.is_new ? fresh("new ") : found.is_accepted ? "accepted " : "";
  std::string text =
      fmt::format("{}{}: {} times, worst {:.2g} of the size\n", how,
                  is_bad ? bad(found.bucket) : found.bucket, found.count, found.error.magnitude);
  if (!found.objection.empty()) text += fmt::format("  {}\n", bad(found.objection));
  if (!found.file.empty()) text += fmt::format("  {}\n", found.file);
  const auto bucket = find_bucket(found.bucket);
  const bool is_open = found.is_new || (bucket && is_unexplained(bucket->verdict));
  return is_open && !found.is_accepted ? text + fmt::format("  {}\n", found.command) : text;
}

std::string case_heading(const Campaign& campaign) {
  const CampaignResult& result = campaign.result;
  return fmt::format("{} against {} {}: {} cases in {:.1f} s ({:.0f} a second, {} jobs), seed {}\n",
                     result.settings.subject, result.settings.oracle,
                     campaign.plan.oracle.declaration.version, result.cases(), result.seconds(),
                     rate(result.cases(), result.seconds()), result.jobs, campaign.plan.seed);
}

/// What is left to do about the files of a run.
std::string remarks_on_files(const CampaignResult& result) {
  std::string text;
  if (result.unshrunk > 0) {
    text += fmt::format(
        "\n{} of the new findings are not as small as can be, for there was no "
        "more time: manifuzz shrink DIR goes on\n",
        result.unshrunk);
  }
  return text + stale_in_words(result.stale);
}

}  // namespace

std::string summary_table(const Campaign& campaign, const std::optional<CampaignResult>& baseline) {
  const CampaignResult& result = campaign.result;
  std::string text =
      result.is_of_sequences()
          ? fmt::format("{}\n{}", sequence_heading(result, campaign.plan.seed), motion_rows(result))
          : fmt::format("{}\n{}", case_heading(campaign), regime_rows(result));
  text += '\n' + verdict_rows(result);
  if (!result.ledger.empty()) text += '\n' + ledger_rows(result);
  if (!result.buckets.empty()) text += '\n';
  text += lines_of(result.buckets, bucket_rows);
  if (campaign.plan.until_new && !campaign.run.sought && !has_new(campaign.findings)) {
    text += "\nnothing new: the corpus shows each of these already\n";
  }
  text += remarks_on_files(result);
  text += state_in_words(campaign);
  if (baseline) text += '\n' + comparison_text(*baseline, campaign.result);
  return text;
}

std::string objections(const Campaign& campaign) {
  std::string text;
  for (const BucketResult& found : campaign.result.buckets) {
    if (decides_status(found)) text += bucket_rows(found);
  }
  for (const LedgerResult& entry : campaign.result.ledger) {
    const std::string over = over_budget_in_words(entry);
    if (!over.empty()) text += fmt::format("{}\n{}", entry.id, over);
  }
  return text + state_in_words(campaign);
}

std::string progress_line(const Plan& plan, const Progress& progress) {
  if (!progress.saving.empty()) return progress.saving;
  const Tally& tally = progress.tally;
  const double per_second = rate(tally.cases(), progress.seconds);
  double left = 0;
  if (plan.seconds) left = *plan.seconds - progress.seconds;
  if (plan.cases && per_second > 0) {
    left = static_cast<double>(*plan.cases - std::min(*plan.cases, tally.cases())) / per_second;
  }
  std::string line = fmt::format(
      "{} {}, {:.0f} a second; agree {}, tie {}, known {}, unexplained {}", tally.cases(),
      plan.sequences ? "sequences" : "cases", per_second, tally.count(Verdict::agree),
      tally.count(Verdict::tie), tally.count(Verdict::known), tally.unexplained());
  if (plan.until_new) line += "; waiting for a new bucket";
  if (plan.seconds || plan.cases) line += fmt::format("; {:.0f} s left", std::max(0.0, left));
  return line;
}

std::string merged_text(const MergedRuns& runs, std::size_t cases, const std::string& folder) {
  std::string text;
  if (!runs.findings.empty()) {
    text = fmt::format("{}: {} findings of {} cases\n", printable(folder, 200),
                       runs.findings.size(), cases);
  }
  if (!runs.result) return text;
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    text += fmt::format("{:<18}{:>14}\n", kVerdictNames[i], runs.result->verdicts[i]);
  }
  return text + fmt::format("{:<18}{:>14}\n", "cases", runs.result->cases());
}

std::string collider_line(const Declaration& declaration) {
  return fmt::format("{:<17} {} ({}, {}, rounds in the {} frame, tie bias {}, up to {} vertices)\n",
                     declaration.name, declaration.description, declaration.version,
                     declaration.scalar == ScalarType::float32 ? "float" : "double",
                     declaration.frame == RoundingFrame::local ? "pair's" : "world's",
                     in_words(declaration.tie_bias), declaration.max_vertices);
}

std::string list_regimes() {
  return lines_of(regimes(), [](const Regime& regime) {
    return fmt::format("{:<16} {}\n", regime.name, regime.description);
  });
}

std::string list_sweeps() {
  const std::string lines = lines_of(sweeps(), [](const Sweep& sweep) {
    return fmt::format("{:<10} {}: {} ({}), {:g} to {:g} in {} steps\n", sweep.name,
                       sweep.description, sweep.knob, sweep.unit, sweep.values.front(),
                       sweep.values.back(), sweep.values.size());
  });
  return lines + lines_of(walks(), [](const Walk& walk) {
           return fmt::format("{:<10} {}\n", walk.name, walk.description);
         });
}

std::string list_scenes() {
  return lines_of(scene_specs(), [](const SceneSpec& spec) {
    return fmt::format("{:<14} {}\n", spec.name, spec.sentence);
  });
}

std::string list_ledger() {
  return lines_of(ledger(), [](const LedgerEntry& entry) {
    return fmt::format("{:<34} {} [{}{}; witness corpus/{}]\n", entry.id, entry.description,
                       entry.source, entry.is_no_bug ? "; no bug" : "", witness_of(entry));
  });
}

}  // namespace manifuzz
