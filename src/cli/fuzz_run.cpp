#include "cli/fuzz_run.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/user_error.hpp"
#include "campaign/budgets.hpp"
#include "campaign/in_child.hpp"
#include "campaign/rounds.hpp"
#include "cli/fuzz_report.hpp"
#include "cli/output.hpp"
#include "measure/provenance.hpp"

namespace manifuzz {
namespace {

JobsResult run_watched(const Plan& plan, const KnownBuckets& known) {
  Interruption interruption;
  ProgressLine line;
  return run_plan(plan, known, interruption,
                  [&](const Progress& progress) { line.show(progress_line(plan, progress)); });
}

/// A second signal ends the saving. The first one ended the shrinking: what it cut short is begun
/// again without.
void save_unless_hurried(Finding& finding, const Plan& plan, const std::string& corpus,
                         Interruption& interruption) {
  try {
    save_finding(finding, plan, corpus, interruption);
  } catch (const Interrupted&) {
    if (interruption.requests() > 1) throw;
    interruption.forgive();
    save_finding(finding, plan, corpus, interruption);
  }
}

/// What is new, what decides the status first: there may not be time for all.
std::vector<Finding*> to_save(std::vector<Finding>& found) {
  std::vector<Finding*> fresh;
  for (Finding& finding : found) {
    if (finding.is_new) fresh.push_back(&finding);
  }
  std::ranges::stable_sort(fresh, {}, [](const Finding* finding) {
    return !decides_status(finding->bucket, finding->is_new);
  });
  return fresh;
}

/// Writes what is new; where somebody has asked to stop, as it was seen.
Saving save_new(std::vector<Finding>& found, const Plan& plan, const SaveTo& save_to,
                bool is_interrupted) {
  // Its own: the signal that ended the campaign may have come twice, and must not end the saving.
  Interruption interruption(save_to.deadline);
  if (is_interrupted) interruption.hurry();
  ProgressLine line;
  Saving saving;
  for (Finding* const finding : to_save(found)) {
    if (interruption.requests() > 1) {
      ++saving.unsaved;
      continue;
    }
    line.show((interruption.requests() == 0 ? "shrinking " : "saving ") +
              to_string(finding->bucket));
    try {
      save_unless_hurried(*finding, plan, save_to.folder, interruption);
    } catch (const Interrupted&) {
      ++saving.unsaved;
    } catch (const UserError& error) {
      if (saving.first_error.empty()) saving.first_error = error.what();
    }
  }
  saving.interrupted = interruption.requests() > 0;
  return saving;
}

Settings settings_of(const Plan& plan) {
  const bool has_radius = plan.context.radius && !plan.is_narrowed;
  return {.subject = plan.subject.declaration.name,
          .oracle = plan.oracle.declaration.name,
          .versions = {},
          .tie_bias = plan.subject.declaration.tie_bias,
          .radius = has_radius ? std::optional<double>(*plan.context.radius) : std::nullopt,
          .judge_every = plan.judge_every};
}

void tell_provenance(CampaignResult& result, const Plan& plan) {
  const std::array declarations{plan.subject.declaration, plan.oracle.declaration};
  const nlohmann::ordered_json json = provenance(plan.seed, declarations);
  result.machine = json.at("machine");
  result.compiler = json.at("compiler");
  result.settings = settings_of(plan);
  for (const auto& [name, version] : json.at("versions").items()) {
    result.settings.versions.emplace_back(name, version);
  }
}

RegimeResult regime_result(const Regime& regime, const RegimeTally& tally) {
  return {std::string(regime.name), tally.cases, tally.touching, tally.near, tally.unexplained};
}

LedgerResult ledger_result(const LedgerCount& count, const Plan& plan, const Tally& tally) {
  LedgerResult entry{std::string(count.entry->id), count.hits, {}, count.over_budget};
  for (std::size_t r = 0; r < plan.regimes.size(); ++r) {
    const std::uint64_t hits = tally.explained[index_of(*count.entry)][r];
    if (hits > 0) entry.regimes[std::string(plan.regimes[r]->name)] = hits;
  }
  return entry;
}

BucketResult bucket_result(const Finding& finding, const Plan& plan, const std::string& command) {
  const CaseNumber first = finding.tally.first;
  const std::string regime(plan.regimes[plan.regime_of(first)]->name);
  return {.bucket = to_string(finding.bucket),
          .verdict = std::string(to_string(finding.bucket.verdict)),
          .count = finding.tally.count,
          .seed = plan.seed,
          .first_index = plan.index_of(first),
          .regime = regime,
          .magnitude = finding.tally.magnitude,
          .file = finding.file,
          .command = fmt::format("{} --regime {} --seed {} --first {} --cases 1", command, regime,
                                 plan.seed, plan.index_of(first)),
          .is_new = finding.is_new};
}

CampaignResult result_of(const Campaign& campaign, const std::string& command) {
  const Plan& plan = campaign.plan;
  const Tally& tally = *campaign.run.tally;
  CampaignResult result;
  tell_provenance(result, plan);
  result.jobs = static_cast<std::uint64_t>(plan.jobs);
  result.verdicts = tally.verdicts;
  result.of_subject = tally.of_subject;
  result.of_oracle = tally.of_oracle;
  result.interrupted = campaign.run.interrupted || campaign.saving.interrupted;
  result.stopped_early = campaign.run.unresponsive != Fault::none;
  result.budgets_hold = holds_budgets(plan);
  CasesRun part{plan.seed, plan.first, {}, campaign.run.seconds};
  for (std::size_t i = 0; i < plan.regimes.size(); ++i) {
    result.regimes.push_back(regime_result(*plan.regimes[i], tally.regimes[i]));
    part.cases[result.regimes.back().name] = tally.regimes[i].cases;
  }
  result.parts = {part};
  for (const LedgerCount& count : ledger_counts(tally, plan)) {
    result.ledger.push_back(ledger_result(count, plan, tally));
  }
  for (const Finding& finding : campaign.findings) {
    result.buckets.push_back(bucket_result(finding, plan, command));
  }
  return result;
}

}  // namespace

void narrow_to_colliders(Plan& plan) {
  plan.is_narrowed =
      !plan.subject.declaration.takes_radius || !plan.oracle.declaration.takes_radius;
  if (plan.is_narrowed) plan.context.radius = 0.0F;
}

Campaign run_campaign(Plan plan, const KnownBuckets& known, const SaveTo& save_to,
                      const std::string& command) {
  Campaign campaign{std::move(plan), {}, {}, {}, {}};
  campaign.run = run_watched(campaign.plan, known);
  campaign.findings = findings(*campaign.run.tally, campaign.plan, known);
  if (!save_to.folder.empty()) {
    campaign.saving = save_new(campaign.findings, campaign.plan, save_to, campaign.run.interrupted);
  }
  campaign.result = result_of(campaign, command);
  return campaign;
}

}  // namespace manifuzz
