#include <algorithm>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/result.hpp"
#include "campaign/run.hpp"
#include "cli/campaign_options.hpp"
#include "cli/campaign_page.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "engines/provenance.hpp"
#include "report/campaign_text.hpp"
#include "report/ci/ci_output.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

struct FuzzArguments : CampaignOptions {
  std::string share;
  std::optional<std::uint64_t> first;
  std::optional<std::uint64_t> judge_every;
  bool until_new = false;
  std::optional<double> until_risk;
  bool has_ties = false;
  std::string baseline;
  CiOutput ci;
};

/// Which cases, and who is asked about them.
void plan_cases(Plan& plan, const FuzzArguments& options) {
  const SubjectAndOracle& asked = options.colliders;
  if (const OtherKind* const kind = kind_for(asked.subject)) {
    expect_none_of(*kind, {{"--oracle", asked.oracle.is_chosen},
                           {"--oracle-command", !asked.oracle.command.empty()},
                           {"--tie-bias", options.tie_bias.has_value()},
                           {"--radius", options.radius.has_value()},
                           {"--judge-every", options.judge_every.has_value()}});
    expect_regimes_of(*kind, options.regimes);
    return kind->plan(plan, asked, options.regimes);
  }
  plan_pairs(plan, options);
}

/// All of the plan that options decide; what is wrong with them comes before a seed is drawn.
Plan plan_of(const FuzzArguments& options) {
  Plan plan;
  plan_cases(plan, options);
  plan.first = options.first.value_or(0);
  plan.cases = options.cases;
  expect_indices(plan.first, plan.cases.value_or(1), plan.regimes.size());
  if (!options.share.empty()) narrow_to_share(share_of(options.share), plan);
  plan.until_new = options.until_new;
  plan.until_risk = options.until_risk;
  expect_risk(plan);
  plan.has_ties = options.has_ties;
  plan.seconds = options.seconds;
  const bool has_end = options.cases || options.seconds || options.until_new || options.until_risk;
  if (!has_end) plan.seconds = kSecondsUnsaid;
  plan.jobs = jobs_of(options.jobs);
  plan.judge_every = options.judge_every.value_or(usual_judge_every(plan.subject, plan.oracle));
  return plan;
}

/// Without an oracle where it has none.
SubjectAndOracle asked_again(const FuzzArguments& options) {
  SubjectAndOracle again = options.colliders;
  if (kind_for(again.subject) != nullptr) again.oracle.name.clear();
  return again;
}

/// The beginning of a command that repeats a case: whatever it depends on besides regime, seed and
/// index.
std::string repeating_command(const FuzzArguments& options) {
  std::string command =
      fmt::format("{} fuzz {}", this_program(), options_again(asked_again(options)));
  command += bias_and_radius_again(options);
  if (options.judge_every) command += fmt::format(" --judge-every {}", *options.judge_every);
  return command + options.folders.again();
}

ShowAgain show_again(const FuzzArguments& options) {
  return {this_program(), options_to_show(asked_again(options))};
}

/// Everything that was asked for; one output that fails loses no other.
Outputs write_all(const Campaign& campaign, const std::optional<CampaignResult>& baseline,
                  const FuzzArguments& options) {
  nlohmann::ordered_json summary = json_of(campaign.result);
  if (baseline) summary["baseline"] = comparison_json(compared(*baseline, campaign.result));
  Outputs outputs;
  outputs.write(!options.ci.stdout_is_data, [&] {
    const bool is_terse = leaves_out_tables(options.json);
    write_to_reader(is_terse ? objections(campaign)
                    : options.is_verbose
                        ? summary_table(campaign, baseline)
                        : campaign_screen(campaign, show_again(options), baseline));
  });
  outputs.write(!options.json.empty(), [&] { write_data(options.json, json_text(summary)); });
  outputs.write(!options.report.empty(), [&] {
    write_data(
        options.report,
        page_of_campaign(campaign, summary, {options.colliders, options.folders, options.json}));
    if (options.report != "-") write_remark("wrote the page " + options.report);
  });
  outputs.add_error(unwritten_in_words(campaign.saving));
  if (is_wanted(options.ci)) {
    Interruption interruption(kUntilSignal);
    write_ci(options.ci, {fuzz_suite(campaign, interruption)}, outputs);
  }
  return outputs;
}

CommandFiles files_of(const FuzzArguments& options) {
  CommandFiles files{{options.folders.saved(),
                      {.option = "--json", .path = options.json, .replaces = options.baseline},
                      {"--report", options.report}},
                     options.folders.all()};
  if (!options.baseline.empty()) files.inputs.emplace_back(options.baseline);
  return files;
}

Campaign run_with_progress(const Plan& plan, const Known& known, const FuzzArguments& options) {
  const SaveTo saved = save_to_of(options);
  const Origin origin{repeating_command(options), provenance(plan.seed, asked_by(plan))};
  const ProgressLine line;
  return run_campaign(plan, known, saved, origin,
                      [&](const Progress& progress) { line.show(progress_line(plan, progress)); });
}

int fuzz(FuzzArguments& options) {
  options.folders.make_relative();
  check_outputs(files_of(options), options.ci);
  const Corpus corpus = read_corpus_folder(options.folders.corpus());
  const Corpus all = read_whole(options.folders);
  Plan plan = plan_of(options);
  std::optional<CampaignResult> baseline;
  if (!options.baseline.empty()) baseline = read_baseline(options.baseline);
  plan.seed = seed_or_draw(options.seed);
  const std::vector<PairCase> pairs = pairs_of(corpus, plan.seed);
  plan.context.corpus = pairs;
  Known known = known_of(all.of(plan.work->kind()), options.today);
  if (baseline) add_baseline(*baseline, plan, known);
  Campaign campaign = run_with_progress(plan, known, options);
  if (baseline) hold_against(*baseline, campaign.result);
  if (!write_all(campaign, baseline, options).are_written()) return 2;
  // Whoever deals shares takes 1 for done.
  if (!options.share.empty() && campaign.result.interrupted) return 0;
  return has_failed(campaign.result) ? 1 : 0;
}

void add_fuzz_arguments(CLI::App& app, FuzzArguments& options) {
  add_subject_and_oracle(app, options.colliders);
  add_sequences(app, options.colliders.subject);
  add_seed(app, options.seed);
  CLI::Option* const cases =
      add_whole_number(app, "--cases", options.cases, "number of cases, over all regimes", 1);
  add_length(app, "--seconds", options.seconds,
             "duration of the run in seconds, over all regimes; default: 10")
      ->excludes(cases);
  app.add_flag("--until-new", options.until_new,
               "stop at the first wrong case that the corpus does not show; without --cases and "
               "--seconds the run has no other end");
  add_chance(
      app, "--until-risk", options.until_risk,
      "stop once the next case shows a bucket not yet seen with a chance of at most P, with 95% "
      "confidence; without --cases and --seconds the run has no other end")
      ->excludes("--until-new");
  add_text(
      app, "--share", options.share, "K/N",
      "run the share K of N, K from 0 to N - 1, of the cases that --seed and --cases give; all "
      "shares, merged, are the whole run")
      ->needs("--seed")
      ->needs("--cases")
      ->excludes("--until-new")
      ->excludes("--until-risk");
  app.add_flag("--ties", options.has_ties, "shrink and save new ties, too");
  add_shrinking(app, options);
  add_whole_number(app, "--first", options.first,
                   "index of the first case in each regime; default: 0");
  add_jobs(app, options.jobs);
  add_whole_number(
      app, "--judge-every", options.judge_every,
      "judge one in N of the cases on which both agree, too; default: 256, or 1 if a collider runs "
      "in its own process",
      1);
  add_pairs_and_folders(app, options);
  add_text(
      app, "--baseline", options.baseline, "FILE",
      "--json output of an earlier run: print which buckets are new, worse or gone; exit with 1 "
      "only for new or worse ones");
  add_summaries(app, options, "this run");
  add_junit(app, options.ci.junit);
}

}  // namespace

Run define_fuzz(CLI::App& app) {
  return define<FuzzArguments, add_fuzz_arguments, fuzz>(app);
}

}  // namespace manifuzz
