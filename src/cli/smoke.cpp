#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/text.hpp"
#include "cases/user_error.hpp"
#include "cli/commands.hpp"
#include "cli/fuzz_run.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/parties.hpp"
#include "cli/property_check.hpp"
#include "cli/replay_run.hpp"
#include "report/style.hpp"

namespace manifuzz {
namespace {

using Clock = std::chrono::steady_clock;

/// Whoever is asked, it is over in 20 s: what is left of them is for a last answer.
constexpr double kSecondsMax = 18;
/// When each part must be done, as shares of the time.
constexpr double kReplayShare = 0.25;
constexpr double kPropertyShare = 0.5;
constexpr double kCampaignShare = 0.75;
constexpr double kSavingShare = 0.95;
constexpr double kPicturesShare = 1;
/// Where the collider took all of its time to start.
constexpr double kCampaignSecondsMin = 0.5;
constexpr int kPropertyCases = 200;

struct Options {
  Parties parties;
  std::optional<std::uint64_t> seed;
  std::optional<double> seconds;
  std::string corpus = "corpus";
  bool no_save = false;
  CiOutput ci;
};

/// The clock that all of it hangs on.
struct Schedule {
  Clock::time_point start = Clock::now();
  double seconds = kSecondsMax;

  Deadline at(double share) const {
    return start + std::chrono::duration_cast<Clock::duration>(
                       std::chrono::duration<double>(share * seconds));
  }
  double seconds_until(double share) const {
    return share * seconds - std::chrono::duration<double>(Clock::now() - start).count();
  }
};

/// What every part works on.
struct Smoke {
  Schedule schedule;
  std::string corpus_folder;
  Corpus corpus;
  Collider subject;
  Collider oracle;
  std::uint64_t seed = 0;
  std::vector<PairCase> pairs;

  std::string corpus_again() const {
    return corpus_folder == "corpus" ? "" : " --corpus " + quoted_for_shell(corpus_folder);
  }
};

ReplayRun replay_some(const Smoke& smoke) {
  Interruption interruption(smoke.schedule.at(kReplayShare));
  const ReplayRun run = replay_cases(smoke.corpus.cases, smoke.subject, smoke.oracle, interruption);
  if (interruption.requests() > 0) throw UserError("smoke: interrupted");
  write_to_reader(replay_text(run, smoke.subject, smoke.oracle) + (is_quiet() ? "" : "\n"));
  return run;
}

/// A property that holds, in a line.
std::string brief_text(const CheckedProperty& checked) {
  const auto& [name, sentence] = std::tie(checked.property->name, checked.property->sentence);
  if (checked.is_left_out()) return fmt::format("--   {}: left out, for time was up\n", name);
  return fmt::format("{} {}: {}, {} cases\n", good("ok  "), name, sentence, checked.result.cases);
}

std::vector<CheckedProperty> check_some(const Smoke& smoke, const std::string& save_to,
                                        Outputs& outputs) {
  std::vector<const Property*> all;
  for (const Property& property : properties()) all.push_back(&property);
  PropertyPlan plan;
  plan.seed = smoke.seed;
  plan.cases = kPropertyCases;
  plan.corpus = smoke.pairs;
  plan.deadline = smoke.schedule.at(kPropertyShare);
  const auto tell = [&](const CheckedProperty& one) {
    if (one.result.passed && is_quiet()) return;
    write_to_reader(one.result.passed ? brief_text(one) : property_text(one));
    outputs.write(!one.why_unsaved.empty(), [&] { throw UserError(one.why_unsaved); });
  };
  return check_properties(all, smoke.subject, plan, save_to, tell);
}

Plan plan_of(const Smoke& smoke) {
  Plan plan;
  plan.subject = smoke.subject;
  plan.oracle = smoke.oracle;
  plan.regimes = choose_regimes({});
  narrow_to_colliders(plan);
  plan.context.corpus = smoke.pairs;
  plan.seed = smoke.seed;
  plan.seconds = std::max(kCampaignSecondsMin, smoke.schedule.seconds_until(kCampaignShare));
  plan.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return plan;
}

Smoke prepared(const Options& options) {
  Smoke smoke;
  smoke.schedule.seconds = options.seconds.value_or(kSecondsMax);
  if (smoke.schedule.seconds <= 0 || smoke.schedule.seconds > kSecondsMax) {
    throw UserError(fmt::format("--seconds: {} s are not on; more than 0, up to {} is expected",
                                smoke.schedule.seconds, kSecondsMax));
  }
  // No absolute path goes into what is kept.
  if (!options.corpus.empty())
    smoke.corpus_folder = std::filesystem::proximate(options.corpus).string();
  smoke.corpus = read_corpus_folder(smoke.corpus_folder);
  smoke.subject = find_subject(options.parties);
  smoke.oracle = find_oracle(options.parties);
  smoke.seed = seed_or_draw(options.seed);
  smoke.pairs = pairs_of(smoke.corpus, smoke.seed);
  return smoke;
}

int run(const Options& options) {
  const Smoke smoke = prepared(options);
  const std::string save_to = options.no_save ? "" : smoke.corpus_folder;
  Outputs outputs;
  const ReplayRun replayed = replay_some(smoke);
  const std::vector<CheckedProperty> checked = check_some(smoke, save_to, outputs);
  const Plan plan = plan_of(smoke);
  const KnownBuckets known(smoke.corpus.cases);
  JobsResult jobs = run_watched(plan, known);
  std::vector<Finding> found = findings(*jobs.tally, plan, known);

  Saving saving;
  if (!options.no_save) {
    Interruption until_saved(smoke.schedule.at(kSavingShare));
    saving = save_new(found, plan, save_to, until_saved);
    outputs.write(!saving.first_error.empty(), [&] { throw UserError(saving.first_error); });
  }
  jobs.interrupted = jobs.interrupted || saving.interrupted;
  const std::string again = options_again(options.parties);
  const CampaignReport report{
      plan,
      jobs,
      found,
      ledger_counts(*jobs.tally, plan),
      {},
      saving.unsaved,
      fmt::format("{} fuzz {}{}", this_program(), again, smoke.corpus_again())};
  std::string text = is_quiet() ? objections(report) : '\n' + summary_table(report);
  if (saving.unsaved > 0) {
    text += fmt::format("\n{} findings are not saved, for time was up\n", saving.unsaved);
  }
  write_to_reader(text);

  Interruption until_drawn(smoke.schedule.at(kPicturesShare));
  const bool pictures = shows_pictures(options.ci);
  const std::string property_again =
      fmt::format("{} --seed {}{}", options_again(options.parties.subject, {}), smoke.seed,
                  smoke.corpus_again());
  const std::vector<TestSuite> suites{
      replay_suite(replayed, smoke.subject, smoke.oracle, again, pictures, until_drawn),
      property_suite(checked, smoke.subject, property_again, pictures, until_drawn),
      fuzz_suite(report, pictures, until_drawn)};
  write_ci(options.ci, suites, outputs);
  if (!outputs.are_written()) return 2;
  return suites[0].failures() + suites[1].failures() + suites[2].failures() > 0 ? 1 : 0;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  add_collider(app, options->parties.subject, "the collider under test");
  add_collider(app, options->parties.oracle, "the collider it is held against");
  add_whole_number(app, "--seed", options->seed,
                   "what the cases hang on; drawn and printed if not given");
  add_length(app, "--seconds", options->seconds,
             "how long altogether; 18 if not given, and at most");
  app.add_option("--corpus", options->corpus,
                 "the folder of known cases, which is replayed, and where new ones are saved")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_flag("--no-save", options->no_save, "shrink and save nothing");
  add_junit(app, options->ci);
  return [options] { return run(*options); };
}

}  // namespace

extern const Command kSmoke;
const Command kSmoke{
    "smoke",
    "Corpus, properties and a campaign in at most 20 s, however slow the collider: for CI.",
    "manifuzz smoke --subject clip --oracle box2d --seed 1 --no-save --junit smoke.xml", define};

}  // namespace manifuzz
