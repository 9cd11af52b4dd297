#include <algorithm>

#include <fmt/format.h>

#include "base/text.hpp"
#include "generating/sweep.hpp"
#include "measure/scene/scene_list.hpp"
#include "report/campaign_text.hpp"
#include "report/outputs.hpp"
#include "report/risk_text.hpp"
#include "report/rows.hpp"

namespace manifuzz {

std::string progress_line(const Plan& plan, const Progress& progress) {
  if (!progress.saving.empty()) return progress.saving;
  const Tally& tally = progress.tally;
  const double a_second = per_second(tally.cases(), progress.seconds);
  double left = 0;
  if (plan.seconds) left = *plan.seconds - progress.seconds;
  if (plan.cases && a_second > 0) {
    left = static_cast<double>(*plan.cases - std::min(*plan.cases, tally.cases())) / a_second;
  }
  std::string line =
      fmt::format("{} {}, {:.0f} a second; agree {}, tie {}, known {}, unexplained {}",
                  tally.cases(), plan.work->noun(), a_second, tally.count(Verdict::agree),
                  tally.count(Verdict::tie), tally.count(Verdict::known), tally.unexplained());
  if (plan.until_new) line += "; waiting for a new bucket";
  if (plan.until_risk) line += fmt::format("; until the risk is at most {:g}", *plan.until_risk);
  if (plan.seconds || plan.cases) line += fmt::format("; {:.0f} s left", std::max(0.0, left));
  return line;
}

std::string merged_text(const MergedRuns& runs, std::size_t cases, const std::string& folder) {
  std::string text;
  if (!runs.findings.empty()) {
    text = fmt::format("{}: {} of {}\n", printable(folder, 200),
                       counted(runs.findings.size(), "finding"), counted(cases, "case"));
  }
  if (!runs.result) return text;
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    text += fmt::format("{:<18}{:>14}\n", kVerdictNames[i], runs.result->verdicts[i]);
  }
  text += fmt::format("{:<18}{:>14}\n", "cases", runs.result->cases());
  const std::string risk = risk_in_words(*runs.result);
  return risk.empty() ? text : text + risk + '\n';
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
  std::string lines;
#define MANIFUZZ_LINE(name, sentence) lines += fmt::format("{:<14} {}\n", #name, sentence);
  MANIFUZZ_SCENES(MANIFUZZ_LINE)
#undef MANIFUZZ_LINE
  return lines;
}

std::string list_ledger() {
  return lines_of(ledger(), [](const LedgerEntry& entry) {
    return fmt::format("{:<34} {} [{}{}; witness corpus/{}]\n", entry.id, entry.description,
                       entry.source, entry.is_no_bug ? "; no bug" : "", witness_of(entry));
  });
}

}  // namespace manifuzz
