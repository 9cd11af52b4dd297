#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "cli/campaign_progress.hpp"
#include "cli/collider_options.hpp"
#include "cli/commands.hpp"
#include "cli/fuzz_report.hpp"
#include "cli/fuzz_suite.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
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
  ComparedColliders parties;
  std::optional<std::uint64_t> seed;
  std::optional<double> seconds;
  std::string corpus = "corpus";
  bool no_save = false;
  CiOutput ci;
};

/// The clock that all of it depends on.
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
  std::string save_to;  ///< the same, or nowhere
  Corpus corpus;
  Collider subject;
  Collider oracle;
  std::uint64_t seed = 0;
  std::vector<PairCase> pairs;

  std::string parties_again;  ///< the options that choose them
  std::string subject_again;
  CiOutput ci;

  std::string corpus_again() const {
    return corpus_folder == "corpus" ? "" : " --corpus " + quoted_for_shell(corpus_folder);
  }
  void tell(const std::string& text, Outputs& outputs) const {
    outputs.write(!ci.stdout_is_data, [&] { write_to_reader(text); });
  }
};

ReplayRun replay_some(const Smoke& smoke, Outputs& outputs) {
  Interruption interruption(
      {.begins = Interruption::State::hurried, .stopped_at = smoke.schedule.at(kReplayShare)});
  const ReplayRun run = replay_cases(smoke.corpus.cases, smoke.subject, smoke.oracle, interruption);
  smoke.tell(replay_text(run, smoke.subject, smoke.oracle) + (is_quiet() ? "" : "\n"), outputs);
  return run;
}

/// A property that holds, in a line.
std::string brief_text(const CheckedProperty& checked) {
  const auto& [name, sentence] = std::tie(checked.property->name, checked.property->sentence);
  if (checked.is_left_out()) return fmt::format("--   {}: left out, for time was up\n", name);
  return fmt::format("{} {}: {}, {} cases\n", good("ok  "), name, sentence, checked.result.cases);
}

std::vector<CheckedProperty> check_some(const Smoke& smoke, Outputs& outputs) {
  std::vector<const Property*> chosen;
  for (const Property& property : properties()) chosen.push_back(&property);
  PropertyPlan plan;
  plan.seed = smoke.seed;
  plan.cases = kPropertyCases;
  plan.corpus = smoke.pairs;
  return check_properties(chosen, smoke.subject, plan, smoke.schedule.at(kPropertyShare),
                          smoke.save_to, [&](const CheckedProperty& one) {
                            if (!one.holds()) smoke.tell(property_text(one), outputs);
                            if (one.holds() && !is_quiet()) smoke.tell(brief_text(one), outputs);
                            outputs.write(!one.why_unsaved.empty(),
                                          [&] { throw UserError(one.why_unsaved); });
                          });
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
  if (!options.corpus.empty()) smoke.corpus_folder = kept_path(options.corpus).string();
  smoke.save_to = options.no_save ? "" : smoke.corpus_folder;
  smoke.corpus = read_known(smoke.corpus_folder);
  write_complaints(smoke.corpus.errors);
  ComparedColliders parties = options.parties;
  const bool are_programs = !parties.subject.command.empty() && !parties.oracle.command.empty();
  if (are_programs) parties.outside.start_seconds = kStartSecondsMax / 2;
  smoke.subject = find_subject(parties);
  smoke.oracle = find_oracle(parties);
  smoke.parties_again = options_again(options.parties);
  smoke.subject_again = options_again(options.parties.subject, {});
  smoke.seed = seed_or_draw(options.seed);
  smoke.pairs = pairs_of(smoke.corpus, smoke.seed);
  smoke.ci = options.ci;
  return smoke;
}

Campaign campaign_of(const Smoke& smoke, Outputs& outputs) {
  const std::string again =
      fmt::format("{} fuzz {}{}", this_program(), smoke.parties_again, smoke.corpus_again());
  Campaign campaign = run_with_progress(plan_of(smoke), KnownBuckets(smoke.corpus.cases),
                                        {smoke.save_to, smoke.schedule.at(kSavingShare)}, again);
  std::string text = is_quiet() ? objections(campaign) : '\n' + summary_table(campaign);
  if (campaign.saving.unsaved > 0) {
    text += fmt::format("\n{} findings are not saved, for time was up\n", campaign.saving.unsaved);
  }
  smoke.tell(text, outputs);
  const std::string& unsaved = campaign.saving.first_error;
  outputs.write(!unsaved.empty(), [&] { throw UserError(unsaved); });
  return campaign;
}

/// What the parts came to, as far as there were any before somebody asked to stop.
struct Parts {
  ReplayRun replayed;
  std::vector<CheckedProperty> checked;
  std::optional<Campaign> campaign;

  bool are_well() const {
    return replayed.failures.empty() && std::ranges::all_of(checked, &CheckedProperty::holds) &&
           !(campaign && has_failed(campaign->result));
  }
};

std::vector<TestSuite> suites_of(const Parts& parts, const Smoke& smoke) {
  Interruption until_drawn(
      {.begins = Interruption::State::hurried, .stopped_at = smoke.schedule.at(kPicturesShare)});
  const std::string property_again =
      fmt::format("{} --seed {}{}", smoke.subject_again, smoke.seed, smoke.corpus_again());
  std::vector<TestSuite> suites{
      replay_suite(parts.replayed, smoke.subject, smoke.oracle, smoke.parties_again, until_drawn),
      property_suite(parts.checked, smoke.subject, property_again, until_drawn)};
  if (parts.campaign) suites.push_back(fuzz_suite(*parts.campaign, until_drawn));
  suites.front().errors = smoke.corpus.errors;
  return suites;
}

int run(Options& options) {
  const std::string save_to = options.no_save ? "" : options.corpus;
  check_outputs({{{"--corpus", save_to, OutputPath::Kind::corpus}}, {options.corpus}}, options.ci);
  Interruption all(kUntilSignal);  // a signal in any part
  const Smoke smoke = prepared(options);
  Outputs outputs;
  Parts parts{replay_some(smoke, outputs), {}, {}};
  if (!all.is_stopped()) parts.checked = check_some(smoke, outputs);
  if (!all.is_stopped()) parts.campaign = campaign_of(smoke, outputs);
  outputs.write(all.is_stopped(), [] { throw UserError("smoke: interrupted before it was done"); });
  if (is_wanted(smoke.ci)) write_ci(smoke.ci, suites_of(parts, smoke), outputs);
  if (!outputs.are_written() || !smoke.corpus.errors.empty()) return 2;
  return parts.are_well() ? 0 : 1;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  add_collider(app, options->parties.subject, "the collider under test");
  add_collider(app, options->parties.oracle, "the collider it is held against");
  add_whole_number(app, "--seed", options->seed,
                   "what the cases depend on; drawn and printed if not given");
  add_length(app, "--seconds", options->seconds,
             "how long altogether; 18 if not given, and at most");
  app.add_option("--corpus", options->corpus,
                 "the folder of known cases, which is replayed, and where new ones are saved")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_flag("--no-save", options->no_save, "shrink and save nothing");
  add_junit(app, options->ci);
  return [options] { return run_for_ci("smoke", options->ci, [&] { return run(*options); }); };
}

}  // namespace

extern const Command kSmoke;
const Command kSmoke{
    "smoke",
    "Corpus, properties and a campaign in at most 20 s, however slow the collider: for CI.",
    "manifuzz smoke --subject clip --oracle box2d --seed 1 --no-save --junit smoke.xml", define};

}  // namespace manifuzz
