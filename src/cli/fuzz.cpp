#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "campaign/guarded.hpp"
#include "campaign/rounds.hpp"
#include "cases/file.hpp"
#include "cases/text.hpp"
#include "cases/user_error.hpp"
#include "cli/commands.hpp"
#include "cli/fuzz_report.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/parties.hpp"

namespace manifuzz {
namespace {

constexpr double kDefaultSeconds = 10;
constexpr std::uint64_t kJobsMax = 256;

struct Options {
  Parties parties;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> cases;
  std::optional<double> seconds;
  std::optional<std::uint64_t> first;
  std::optional<std::uint64_t> jobs;
  std::optional<std::uint64_t> judge_every;
  std::vector<std::string> regimes;
  std::optional<double> tie_bias;
  std::optional<double> radius;
  std::string corpus = "corpus";
  std::string json;
  bool no_save = false;
  bool until_new = false;
  std::string baseline;
};

int jobs_of(const Options& options) {
  if (options.jobs && *options.jobs > kJobsMax) {
    throw UserError(fmt::format("--jobs: {} are too many; take 1 to {}", *options.jobs, kJobsMax));
  }
  return static_cast<int>(options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())));
}

/// Both radii together are a float still.
float radius_of(double radius) {
  constexpr float most = std::numeric_limits<float>::max() / 2;
  if (radius <= static_cast<double>(most)) return static_cast<float>(radius);
  throw UserError(fmt::format("--radius: {} is beyond float; take 0 to {}", radius, most));
}

/// All of the plan that options decide; what is wrong with them comes before a seed is drawn.
Plan plan_of(const Options& options) {
  Plan plan;
  plan.subject = find_subject(options.parties, options.tie_bias);
  plan.oracle = find_oracle(options.parties);
  plan.regimes = choose_regimes(options.regimes);
  plan.is_narrowed = !options.radius && !(plan.subject.declaration.takes_radius &&
                                          plan.oracle.declaration.takes_radius);
  if (options.radius) plan.context.radius = radius_of(*options.radius);
  if (plan.is_narrowed) plan.context.radius = 0.0F;
  plan.first = options.first.value_or(0);
  plan.cases = options.cases;
  expect_indices(plan.first, plan.cases.value_or(1), plan.regimes.size());
  plan.until_new = options.until_new;
  plan.seconds = options.seconds;
  const bool is_unlimited = !options.cases && !options.seconds && !options.until_new;
  if (is_unlimited) plan.seconds = kDefaultSeconds;
  plan.jobs = jobs_of(options);
  plan.judge_every = options.judge_every.value_or(kJudgeEvery);
  return plan;
}

/// This program as it was called, relative to the working folder, so that a kept output holds no
/// absolute path; then whatever a case hangs on besides regime, seed and index.
std::string repeating_command(const Options& options) {
  std::string program = "manifuzz";
  std::error_code unknown;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (!unknown) program = quoted_for_shell(std::filesystem::relative(self, unknown).string());
  std::string command = fmt::format("{} fuzz {}", program, options_again(options.parties));
  if (options.tie_bias) command += fmt::format(" --tie-bias {}", *options.tie_bias);
  if (options.radius) command += fmt::format(" --radius {}", *options.radius);
  if (options.judge_every) command += fmt::format(" --judge-every {}", *options.judge_every);
  if (options.corpus != "corpus") command += " --corpus " + quoted_for_shell(options.corpus);
  return command;
}

/// How saving went: one finding that cannot be written does not lose the others.
struct Saving {
  std::string first_error;
  bool interrupted = false;
  std::size_t unsaved = 0;
};

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

/// What a campaign found is saved, even after it was interrupted.
Saving save_new(std::vector<Finding>& found, const Plan& plan, const Options& options) {
  Interruption interruption;
  ProgressLine line;
  Saving saving;
  for (Finding& finding : found) {
    if (!finding.is_new) continue;
    if (interruption.requests() > 1) {
      ++saving.unsaved;
      continue;
    }
    line.show("shrinking " + to_string(finding.bucket));
    try {
      save_unless_hurried(finding, plan, options.corpus, interruption);
    } catch (const Interrupted&) {
      ++saving.unsaved;
    } catch (const UserError& error) {
      if (saving.first_error.empty()) saving.first_error = error.what();
    }
  }
  saving.interrupted = interruption.requests() > 0;
  return saving;
}

int fuzz(Options options) {
  // No absolute path goes into what is kept.
  if (!options.corpus.empty()) options.corpus = std::filesystem::proximate(options.corpus).string();
  const Corpus corpus = read_corpus_folder(options.corpus);
  Plan plan = plan_of(options);
  std::optional<EarlierRun> baseline;
  if (!options.baseline.empty()) baseline = read_baseline(options.baseline);
  plan.seed = seed_or_draw(options.seed);
  const std::vector<PairCase> pairs = pairs_of(corpus, plan.seed);
  plan.context.corpus = pairs;
  const KnownBuckets known(corpus.cases);
  JobsResult run;
  {
    Interruption interruption;
    ProgressLine line;
    run = run_plan(plan, known, interruption,
                   [&](const Progress& progress) { line.show(progress_line(plan, progress)); });
  }
  std::vector<Finding> found = findings(*run.tally, plan, known);
  Saving saving;
  if (!options.no_save) saving = save_new(found, plan, options);
  run.interrupted = run.interrupted || saving.interrupted;

  const CampaignReport report{plan,
                              run,
                              found,
                              ledger_counts(*run.tally, plan),
                              baseline,
                              saving.unsaved,
                              repeating_command(options)};
  // A path or a command need not be UTF-8.
  constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
  const std::string json =
      options.json.empty() ? "" : summary_json(report).dump(2, ' ', false, replace) + '\n';
  const bool is_terse = leaves_out_tables({options.json});
  write_to_reader(options.json == "-" ? json
                  : is_terse          ? objections(report)
                                      : summary_table(report));
  if (!json.empty() && options.json != "-") write_file(options.json, json);
  if (!saving.first_error.empty()) throw UserError(saving.first_error);
  return has_failed(report) ? 1 : 0;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  add_parties(app, options->parties);
  add_whole_number(app, "--seed", options->seed,
                   "what the cases hang on; drawn and printed if not given");
  CLI::Option* const cases =
      add_whole_number(app, "--cases", options->cases, "how many cases, all regimes together", 1);
  add_length(app, "--seconds", options->seconds, "how long, all regimes together; 10 if not given")
      ->excludes(cases);
  app.add_flag("--until-new", options->until_new,
               "until something is found that the corpus does not show; without --cases or "
               "--seconds there is no other end");
  add_whole_number(app, "--first", options->first, "the first index in each regime");
  add_whole_number(app, "--jobs", options->jobs, "how many processes; one a core if not given", 1);
  add_whole_number(app, "--judge-every", options->judge_every,
                   "of the cases that agree, one in so many is judged too; 256 if not given", 1);
  app.add_option("--regime", options->regimes,
                 "a regime to draw from, again for more; all by turns if not given")
      ->type_name("R")
      ->allow_extra_args(false);
  add_length(app, "--tie-bias", options->tie_bias, "the subject's tie bias");
  add_length(app, "--radius", options->radius, "of each polygon; the regime's own if not given");
  app.add_option("--corpus", options->corpus, "the folder of known cases, where new ones are saved")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_flag("--no-save", options->no_save, "shrink and save nothing");
  app.add_option("--baseline", options->baseline,
                 "the --json of an earlier run: says which buckets are new, worse, gone")
      ->type_name("FILE")
      ->check(not_blank);
  app.add_option("--json", options->json, "the summary as JSON, to a file or - for stdout")
      ->type_name("FILE");
  return [options] { return fuzz(*options); };
}

}  // namespace

extern const Command kFuzz;
const Command kFuzz{
    "fuzz", "A campaign: random cases to two colliders; what differs is judged, shrunk, saved.",
    "manifuzz fuzz --regime sliver --seed 1 --cases 100000\n"
    "manifuzz fuzz --until-new --regime sliver --seed 1 --cases 20000",
    define};

}  // namespace manifuzz
