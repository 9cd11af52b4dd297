#include "cli/fuzz_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/text.hpp"
#include "report/provenance.hpp"
#include "report/style.hpp"

namespace manifuzz {
namespace {

std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "-";
  return fmt::format("{:.1f}%", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

double rate(std::uint64_t cases, double seconds) {
  return seconds > 0 ? static_cast<double>(cases) / seconds : 0;
}

std::string regime_rows(const CampaignReport& report) {
  std::string text = fmt::format("{:<18}{:>14}{:>10}{:>8}{:>13}\n", "regime", "cases", "touching",
                                 "near", "unexplained");
  for (std::size_t i = 0; i < report.plan.regimes.size(); ++i) {
    const RegimeTally& regime = report.run.tally->regimes[i];
    text += fmt::format("{:<18}{:>14}{:>10}{:>8}{:>13}\n", report.plan.regimes[i]->name,
                        regime.cases, percent(regime.touching, regime.cases),
                        percent(regime.near, regime.cases), regime.unexplained);
  }
  return text;
}

std::string verdict_rows(const Tally& tally) {
  std::string text;
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    const std::string name = fmt::format("{:<18}", kVerdictNames[i]);
    const bool is_bad = tally.verdicts[i] > 0 && is_unexplained(static_cast<Verdict>(i));
    text += fmt::format("{}{:>14}\n", is_bad ? bad(name) : name, tally.verdicts[i]);
  }
  return text + fmt::format("{:<18}{:>14}\n", "unexplained", tally.unexplained());
}

std::string over_budget_in_words(const LedgerCount& count) {
  if (count.over_budget.empty()) return "";
  return fmt::format("  {}\n",
                     bad(fmt::format("over its budget in {}", fmt::join(count.over_budget, ", "))));
}

std::string ledger_rows(const CampaignReport& report) {
  std::string text;
  for (const LedgerCount& count : report.ledger) {
    text += fmt::format("{:<36}{:>14}{}\n", count.entry->id, count.hits,
                        count.hits == 0 ? "  never fired" : "");
    text += over_budget_in_words(count);
  }
  return text;
}

std::string vacuous_in_words(const CampaignReport& report) {
  if (!is_vacuous(report)) return "";
  return "\nvacuous: nothing touched, so nothing was shown; choose other regimes or a radius\n";
}

std::string interrupted_in_words(const CampaignReport& report) {
  if (!report.run.interrupted) return "";
  return "\ninterrupted: what was found until then is counted" +
         (report.unsaved == 0 ? " and kept\n"
                              : fmt::format(", but {} findings are not saved\n", report.unsaved));
}

/// Why a campaign that was not interrupted ended before its cases did.
std::string hopeless_in_words(const CampaignReport& report) {
  if (report.run.hopeless == Fault::none) return "";
  const Collider& collider =
      report.run.hopeless == Fault::subject ? report.plan.subject : report.plan.oracle;
  return fmt::format("\nstopped early: {} gave no answer again and again: {}\n",
                     collider.declaration.name, printable(report.run.why_hopeless, 200));
}

bool is_any(const Finding&) {
  return true;
}

std::string finding_rows(const CampaignReport& report, bool (*is_shown)(const Finding&)) {
  std::string text;
  for (const Finding& finding : report.findings) {
    if (!is_shown(finding)) continue;
    const std::string bucket = to_string(finding.bucket);
    text += fmt::format("{}{}: {} times, worst {:.2g} of the size\n",
                        finding.is_new ? fresh("new ") : "",
                        decides_status(finding) ? bad(bucket) : bucket, finding.tally.count,
                        finding.tally.magnitude);
    if (!finding.file.empty()) text += fmt::format("  {}\n", finding.file);
    if (finding.is_new || is_unexplained(finding.bucket.verdict)) {
      text += fmt::format("  {}\n", command_of(report, finding));
    }
  }
  return text;
}

}  // namespace

bool is_vacuous(std::span<const RegimeCount> regimes) {
  std::uint64_t cases = 0;
  std::uint64_t touching = 0;
  for (const RegimeCount& regime : regimes) {
    if (regime.name == "separated") continue;
    cases += regime.cases;
    touching += regime.touching;
  }
  return cases >= kVacuousCases && touching == 0;
}

bool is_vacuous(const CampaignReport& report) {
  std::vector<RegimeCount> counts;
  for (std::size_t i = 0; i < report.plan.regimes.size(); ++i) {
    const RegimeTally& regime = report.run.tally->regimes[i];
    counts.push_back({report.plan.regimes[i]->name, regime.cases, regime.touching});
  }
  return is_vacuous(counts);
}

bool decides_status(const Finding& finding) {
  return is_failure(finding.bucket) ||
         (finding.is_new && finding.bucket.verdict == Verdict::oracle_wrong);
}

bool has_failed(const CampaignReport& report) {
  return is_vacuous(report) ||
         std::any_of(report.ledger.begin(), report.ledger.end(),
                     [](const LedgerCount& count) { return !count.over_budget.empty(); }) ||
         std::any_of(report.findings.begin(), report.findings.end(), decides_status);
}

std::string command_of(const CampaignReport& report, const Finding& finding) {
  const CaseNumber first = finding.tally.first;
  return fmt::format("{} --regime {} --seed {} --first {} --cases 1", report.command,
                     report.plan.regimes[report.plan.regime_of(first)]->name, report.plan.seed,
                     report.plan.index_of(first));
}

std::string summary_table(const CampaignReport& report) {
  const Tally& tally = *report.run.tally;
  std::string text =
      fmt::format("{} against {} {}: {} cases in {:.1f} s ({:.0f} a second, {} jobs), seed {}\n\n",
                  report.plan.subject.declaration.name, report.plan.oracle.declaration.name,
                  report.plan.oracle.declaration.version, tally.cases(), report.run.seconds,
                  rate(tally.cases(), report.run.seconds), report.plan.jobs, report.plan.seed);
  text += regime_rows(report) + '\n' + verdict_rows(tally);
  if (!report.ledger.empty()) text += '\n' + ledger_rows(report);
  if (!report.findings.empty()) text += '\n' + finding_rows(report, is_any);
  if (report.plan.until_new && !has_new(report.findings)) {
    text += "\nnothing new: the corpus shows each of these already\n";
  }
  text += vacuous_in_words(report);
  if (report.baseline)
    text += '\n' + differences_in_words(report.baseline->terms, terms_in(summary_json(report))) +
            comparison_rows(compared(report.baseline->buckets, report.findings));
  return text + hopeless_in_words(report) + interrupted_in_words(report);
}

std::string objections(const CampaignReport& report) {
  std::string text = finding_rows(report, decides_status);
  for (const LedgerCount& count : report.ledger) {
    if (!count.over_budget.empty()) {
      text += fmt::format("{}\n{}", count.entry->id, over_budget_in_words(count));
    }
  }
  return text + vacuous_in_words(report) + hopeless_in_words(report) + interrupted_in_words(report);
}

nlohmann::ordered_json summary_json(const CampaignReport& report) {
  const Tally& tally = *report.run.tally;
  const std::array declarations{report.plan.subject.declaration, report.plan.oracle.declaration};
  nlohmann::ordered_json json = provenance(report.plan.seed, declarations);
  json["subject"] = declarations[0].name;
  json["oracle"] = declarations[1].name;
  json["cases"] = tally.cases();
  json["seconds"] = report.run.seconds;
  json["cases_per_second"] = rate(tally.cases(), report.run.seconds);
  json["jobs"] = report.plan.jobs;
  json["touching"] = tally.touching();
  json["near"] = tally.near();
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    json["verdicts"][std::string(kVerdictNames[i])] = tally.verdicts[i];
  }
  json["unexplained"] = tally.unexplained();
  for (const auto& [name, worst] :
       {std::pair("subject", tally.of_subject), std::pair("oracle", tally.of_oracle)}) {
    json["worst_error"][name] = {{"depth", worst.depth}, {"position", worst.position}};
  }
  json["vacuous"] = is_vacuous(report);
  json["interrupted"] = report.run.interrupted;
  json["stopped_early"] = report.run.hopeless != Fault::none;
  json["first"] = report.plan.first;
  json["budgets_hold"] = holds_budgets(report.plan);
  json["regimes"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < report.plan.regimes.size(); ++i) {
    const RegimeTally& regime = tally.regimes[i];
    json["regimes"].push_back({{"name", report.plan.regimes[i]->name},
                               {"cases", regime.cases},
                               {"touching", regime.touching},
                               {"near", regime.near},
                               {"unexplained", regime.unexplained}});
  }
  json["ledger"] = nlohmann::ordered_json::array();
  for (const LedgerCount& count : report.ledger) {
    nlohmann::ordered_json by_regime = nlohmann::ordered_json::object();
    for (std::size_t r = 0; r < report.plan.regimes.size(); ++r) {
      const std::uint64_t hits = tally.explained[index_of(*count.entry)][r];
      if (hits > 0) by_regime[std::string(report.plan.regimes[r]->name)] = hits;
    }
    json["ledger"].push_back({{"id", count.entry->id},
                              {"hits", count.hits},
                              {"regimes", by_regime},
                              {"over_budget", count.over_budget}});
  }
  json["buckets"] = nlohmann::ordered_json::array();
  for (const Finding& finding : report.findings) {
    const CaseNumber first = finding.tally.first;
    json["buckets"].push_back({{"bucket", to_string(finding.bucket)},
                               {"verdict", to_string(finding.bucket.verdict)},
                               {"count", finding.tally.count},
                               {"first_index", report.plan.index_of(first)},
                               {"regime", report.plan.regimes[report.plan.regime_of(first)]->name},
                               {"magnitude", finding.tally.magnitude},
                               {"file", finding.file},
                               {"command", command_of(report, finding)},
                               {"new", finding.is_new}});
  }
  if (report.baseline) {
    json["baseline"] = comparison_json(compared(report.baseline->buckets, report.findings));
  }
  return json;
}

std::string progress_line(const Plan& plan, const Progress& progress) {
  const Tally& tally = progress.tally;
  const double per_second = rate(tally.cases(), progress.seconds);
  double left = 0;
  if (plan.seconds) left = *plan.seconds - progress.seconds;
  if (plan.cases && per_second > 0) {
    left = static_cast<double>(*plan.cases - std::min(*plan.cases, tally.cases())) / per_second;
  }
  std::string line =
      fmt::format("{} cases, {:.0f} a second; agree {}, tie {}, known {}, unexplained {}",
                  tally.cases(), per_second, tally.count(Verdict::agree), tally.count(Verdict::tie),
                  tally.count(Verdict::known), tally.unexplained());
  if (plan.until_new) line += "; waiting for a new bucket";
  if (plan.seconds || plan.cases) line += fmt::format("; {:.0f} s left", std::max(0.0, left));
  return line;
}

}  // namespace manifuzz
