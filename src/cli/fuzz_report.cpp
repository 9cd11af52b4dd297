#include "cli/fuzz_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/text.hpp"
#include "report/provenance.hpp"

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
    text += fmt::format("{:<18}{:>14}\n", kVerdictNames[i], tally.verdicts[i]);
  }
  return text + fmt::format("{:<18}{:>14}\n", "unexplained", tally.unexplained());
}

std::string ledger_rows(const CampaignReport& report) {
  std::string text;
  for (const LedgerCount& count : report.ledger) {
    text += fmt::format("{:<36}{:>14}{}\n", count.entry->id, count.hits,
                        count.hits == 0 ? "  never fired" : "");
    if (count.over_budget.empty()) continue;
    text += fmt::format("  over its budget in {}\n", fmt::join(count.over_budget, ", "));
  }
  return text;
}

/// Why a campaign that was not interrupted ended before its cases did.
std::string hopeless_in_words(const CampaignReport& report) {
  if (report.run.hopeless == Fault::none) return "";
  const Collider& collider =
      report.run.hopeless == Fault::subject ? report.plan.subject : report.plan.oracle;
  return fmt::format("\nstopped early: {} gave no answer again and again: {}\n",
                     collider.declaration.name, printable(report.run.why_hopeless, 200));
}

std::string finding_rows(const CampaignReport& report) {
  std::string text;
  for (const Finding& finding : report.findings) {
    text += fmt::format("{}{}: {} times, worst {:.2g} of the size\n", finding.is_new ? "new " : "",
                        to_string(finding.bucket), finding.tally.count, finding.tally.magnitude);
    if (!finding.file.empty()) text += fmt::format("  {}\n", finding.file);
    if (finding.is_new || is_unexplained(finding.bucket.verdict)) {
      text += fmt::format("  {}\n", command_of(report, finding));
    }
  }
  return text;
}

}  // namespace

bool is_vacuous(const CampaignReport& report) {
  std::uint64_t cases = 0;
  std::uint64_t touching = 0;
  for (std::size_t i = 0; i < report.plan.regimes.size(); ++i) {
    if (report.plan.regimes[i]->name == "separated") continue;
    cases += report.run.tally->regimes[i].cases;
    touching += report.run.tally->regimes[i].touching;
  }
  return cases >= kVacuousCases && touching == 0;
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
  if (!report.findings.empty()) text += '\n' + finding_rows(report);
  if (is_vacuous(report)) {
    text += "\nvacuous: nothing touched, so nothing was shown; choose other regimes or a radius\n";
  }
  if (report.baseline)
    text += '\n' + differences_in_words(report.baseline->terms, terms_in(summary_json(report))) +
            comparison_rows(compared(report.baseline->buckets, report.findings));
  text += hopeless_in_words(report);
  if (report.run.interrupted) {
    text += "\ninterrupted: what was found until then is counted";
    text += report.unsaved == 0 ? " and kept\n"
                                : fmt::format(", but {} findings are not saved\n", report.unsaved);
  }
  return text;
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
  return fmt::format(
      "{} cases, {:.0f} a second; agree {}, tie {}, known {}, unexplained {}; {:.0f} s left",
      tally.cases(), per_second, tally.count(Verdict::agree), tally.count(Verdict::tie),
      tally.count(Verdict::known), tally.unexplained(), std::max(0.0, left));
}

}  // namespace manifuzz
