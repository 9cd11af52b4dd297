#include "campaign/smoke.hpp"

#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "engines/provenance.hpp"
#include "report/campaign_text.hpp"
#include "report/ci/ci_output.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

/// Whoever is asked, it is over in 20 s: what is left of them is for a last answer.
constexpr double kSmokeSecondsMax = 18;

struct SmokeArguments {
  SubjectAndOracle colliders;
  std::optional<std::uint64_t> seed;
  std::optional<double> seconds;
  CorpusFolders folders;
  std::string today;
  CiOutput ci;
};

SmokePlan plan_of(const SmokeArguments& options) {
  SmokePlan plan;
  plan.start = Clock::now();
  plan.seconds = options.seconds.value_or(kSmokeSecondsMax);
  if (plan.seconds <= 0 || plan.seconds > kSmokeSecondsMax) {
    throw UserError(fmt::format("--seconds: {} s is out of range; use more than 0, up to {}",
                                plan.seconds, kSmokeSecondsMax));
  }
  plan.save_to = options.folders.save_to();
  plan.known_cases = read_known(options.folders);
  write_complaints(plan.known_cases.errors);
  plan.corpus = read_known(options.folders.corpus());
  plan.known = known_of(plan.known_cases.cases, options.today);
  const ColliderChoice& subject = options.colliders.subject;
  const ColliderChoice& oracle = options.colliders.oracle;
  ExternalOptions external = options.colliders.external;
  const bool are_programs = !subject.command.empty() && !oracle.command.empty();
  if (are_programs) external.start_seconds = kStartSecondsMax / 2;
  const Clock::time_point before = Clock::now();
  plan.subject = find_collider(subject, external);
  plan.oracle = find_collider(oracle, external);
  plan.start_seconds = seconds_since(before);
  plan.seed = seed_or_draw(options.seed);
  plan.origin = {fmt::format("{} fuzz {}{}", this_program(), options_again(options.colliders),
                             options.folders.again()),
                 provenance(plan.seed, {plan.subject.declaration, plan.oracle.declaration})};
  return plan;
}

std::string campaign_text(const Campaign& campaign, const SmokeArguments& options) {
  const ShowAgain show{this_program(), options_to_show(options.colliders)};
  return is_quiet() ? objections(campaign) : '\n' + campaign_screen(campaign, show);
}

SmokeListener printer(const SmokeArguments& options, const ProgressLine& line, Outputs& outputs) {
  const auto print = [&](const std::string& text) {
    outputs.write(!options.ci.stdout_is_data, [&] { write_to_reader(text); });
  };
  return {[print](const ReplayRun& run) { print(replay_text(run) + (is_quiet() ? "" : "\n")); },
          [print, &outputs](const CheckedProperty& one) {
            if (!one.holds()) print(property_text(one));
            if (one.holds() && !is_quiet()) print(property_line(one));
            outputs.add_error(one.why_unsaved);
          },
          [print, &line, &outputs, &options](const Campaign& campaign) {
            line.show("");
            print(campaign_text(campaign, options));
            outputs.add_error(unwritten_in_words(campaign.saving));
          },
          [&line](const Plan& plan, const Progress& progress) {
            line.show(progress_line(plan, progress));
          }};
}

int smoke(SmokeArguments& options) {
  options.folders.make_relative();
  check_outputs({{options.folders.saved()}, options.folders.all()}, options.ci);
  Interruption all(kUntilSignal);
  const SmokePlan plan = plan_of(options);
  const ProgressLine line;
  Outputs outputs;
  const SmokeRun run = run_smoke(plan, printer(options, line, outputs), all);
  if (all.is_stopped()) outputs.add_interruption("smoke: interrupted before it was done");
  if (is_wanted(options.ci)) {
    const std::string subject_again =
        fmt::format("{} --seed {}{}", options_again(options.colliders.subject, {}), plan.seed,
                    options.folders.again());
    write_ci(options.ci,
             smoke_suites(run, plan, {this_program(), options_again(options.colliders)},
                          {this_program(), subject_again}),
             outputs);
  }
  if (!outputs.are_written() || !plan.known_cases.errors.empty()) return 2;
  return run.is_well() ? 0 : 1;
}

void add_smoke_arguments(CLI::App& app, SmokeArguments& options) {
  add_collider(app, options.colliders.subject, "collider under test");
  add_collider(app, options.colliders.oracle, "collider to compare the subject with");
  add_seed(app, options.seed);
  add_length(app, "--seconds", options.seconds,
             "duration of the whole run in seconds, at most 18; default: 18");
  add_corpus(app, options.folders,
             "folder of known cases, which is replayed, and in which new ones are saved; default: "
             "replay corpus, and save new ones in build/found of the source tree, or in found "
             "outside of it");
  add_no_save(app, options.folders);
  add_today(app, options.today);
  add_junit(app, options.ci.junit);
}

}  // namespace

Run define_smoke(CLI::App& app) {
  return define<SmokeArguments, add_smoke_arguments, smoke>(app);
}

}  // namespace manifuzz
