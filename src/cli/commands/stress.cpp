#include "measure/stress/stress.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file.hpp"
#include "base/names.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "campaign/in_child.hpp"
#include "cli/collider_choice.hpp"
#include "cli/colliders.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/stress_options.hpp"
#include "cli/stress_save.hpp"
#include "corpus/output_check.hpp"
#include "kernel/target.hpp"
#include "measure/provenance.hpp"
#include "measure/stress/breaking_points.hpp"
#include "measure/stress/flush_to_zero.hpp"
#include "report/stress_pictures.hpp"
#include "report/stress_report.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kQuickCases = 600;
constexpr std::uint64_t kQuickFrames = 10'000;

void choose_sweeps(const std::vector<std::string>& names, StressPlan& plan) {
  struct Choice {
    std::string_view name;
    const Sweep* sweep;
    const Walk* walk;
  };
  std::vector<Choice> all;
  for (const Sweep& sweep : sweeps()) all.push_back({sweep.name, &sweep, nullptr});
  for (const Walk& walk : walks()) all.push_back({walk.name, nullptr, &walk});
  for (const Choice* const one : chosen_by_name(all, names, "sweep", "--sweep")) {
    if (one->sweep != nullptr) plan.sweeps.push_back(one->sweep);
    if (one->walk != nullptr) plan.walks.push_back(one->walk);
  }
}

void expect_names_of_their_own(const std::vector<StressSubject>& subjects) {
  for (auto one = subjects.begin(); one != subjects.end(); ++one) {
    if (std::ranges::find(subjects.begin(), one, one->name, &StressSubject::name) == one) continue;
    throw UserError(fmt::format("--collider: there is more than one '{}'", printable(one->name)));
  }
}

/// Every collider that is there, or those that are named; of each that takes a tie bias, a variant
/// for the walks.
std::vector<StressSubject> contestants_of(const StressOptions& options) {
  std::vector<Collider> chosen;
  for (const std::string& name : options.colliders) {
    chosen.push_back(find_collider(ColliderChoice{"collider", name, ""}, options.outside));
  }
  if (!options.program.command.empty()) {
    chosen.push_back(find_collider(options.program, options.outside));
  }
  if (chosen.empty()) {
    for (const ColliderEntry& entry : colliders()) {
      try {
        Collider collider = entry.make();
        if (options.quick && collider.is_isolated()) continue;
        chosen.push_back(std::move(collider));
      } catch (const UserError& error) {
        write_remark(fmt::format("left out: {}", error.what()));
      }
    }
  }
  std::vector<StressSubject> subjects{ideal_subject()};
  for (const Collider& collider : chosen) {
    const std::string name = collider.declaration.name;
    subjects.push_back({name, collider});
    if (collider.with_tie_bias) {
      subjects.push_back({name + " with a bias", collider.with_tie_bias(kWalkBias), true});
    }
  }
  expect_names_of_their_own(subjects);
  if (subjects.size() > kSubjectsMax) {
    throw UserError("--collider: that is too many at once");
  }
  return subjects;
}

StressPlan plan_of(const StressOptions& options) {
  StressPlan plan;
  choose_sweeps(options.sweeps, plan);
  plan.subjects = contestants_of(options);
  plan.seed = options.seed.value_or(plan.seed);
  plan.cases = options.cases.value_or(options.quick ? kQuickCases : plan.cases);
  plan.flush_to_zero = options.flush_to_zero;
  if (plan.flush_to_zero && !can_flush_to_zero()) {
    throw UserError("--flush-to-zero: this processor cannot, or not as it is known here");
  }
  plan.frames = options.frames.value_or(options.quick ? kQuickFrames : plan.frames);
  const std::uint64_t cores = std::max(1U, std::thread::hardware_concurrency());
  plan.jobs = static_cast<int>(std::min<std::uint64_t>(options.jobs.value_or(cores), 1024));
  return plan;
}

std::string progress_line(const StressProgress& progress) {
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  const double left = share > 0 ? progress.seconds / share - progress.seconds : 0;
  return fmt::format("{} of {} cases, {:.0f} a second, {:.0f} s left", progress.done,
                     progress.total, static_cast<double>(progress.done) / progress.seconds, left);
}

/// What a run has against it; nothing where all is as stored, or nothing is.
std::string objections(const Comparison& comparison) {
  std::string text;
  if (!comparison.worse.empty()) {
    text += fmt::format("\nworse than stored:\n{}\n", fmt::join(comparison.worse, "\n"));
  }
  if (!comparison.not_compared.empty()) {
    text += fmt::format("\ninterrupted, and not compared:\n{}\n",
                        fmt::join(comparison.not_compared, "\n"));
  }
  return text;
}

nlohmann::ordered_json report_json(const StressPlan& plan, const StressResult& result,
                                   const Comparison& comparison) {
  std::vector<Declaration> declarations;
  for (const StressSubject& subject : plan.subjects) {
    const bool is_collider = subject.name != kIdealName && !subject.walks_only;
    if (is_collider) declarations.push_back(subject.collider.declaration);
  }
  nlohmann::ordered_json json = provenance(plan.seed, declarations);
  json["machine"]["instruction_set"] = kernel::targets().front();
  json["cases"] = plan.cases;
  json["frames"] = plan.frames;
  json["flush_to_zero"] = plan.flush_to_zero;
  json["seconds"] = result.seconds;
  json["interrupted"] = result.interrupted;
  json["worse"] = comparison.worse;
  json["not_compared"] = comparison.not_compared;
  json["sweeps"] = stress_sweeps_json(plan, result);
  json["walks"] = stress_walks_json(plan, result);
  return json;
}

void save(const StressPlan& plan, const StressResult& result, const std::string& folder,
          Interruption& interruption) {
  const ProgressLine line;
  const std::string corpus = kept_path(folder).string();
  try {
    save_worst(plan, result, corpus, interruption,
               [&](const std::string& name) { line.show("saving " + name); });
  } catch (const Interrupted&) {
    throw UserError("--save: interrupted, not all was saved");
  }
}

/// What a run found is written, even after it was interrupted; another signal ends the writing.
void write_files(const StressPlan& plan, const StressResult& result, const StressOptions& options,
                 const std::string& json, const nlohmann::ordered_json& stored,
                 Interruption& interruption, Outputs& outputs) {
  outputs.write(!options.json.empty() && options.json != "-",
                [&] { write_file(options.json, json); });
  outputs.write(!options.csv.empty(), [&] { write_file(options.csv, stress_csv(plan, result)); });
  outputs.write(!options.store.empty(), [&] {
    if (result.interrupted) throw UserError("--store: interrupted, nothing is stored");
    write_file(options.store, breaking_points_json(plan, result, stored).dump(1, '\t') + '\n');
  });
  outputs.write(!options.save.empty(), [&] { save(plan, result, options.save, interruption); });
  if (options.pictures.empty()) return;
  for (const Sweep* const sweep : plan.sweeps) {
    const bool is_cut_short = interruption.is_stopped();
    outputs.write(true, [&] {
      if (is_cut_short) throw UserError("--pictures: interrupted, not all were drawn");
      write_stress_pictures(options.pictures, plan, result, *sweep);
    });
    if (is_cut_short) return;
  }
}

std::string report_text(const StressPlan& plan, const StressResult& result,
                        const Comparison& comparison) {
  std::string text = result.interrupted ? "interrupted: what was measured until then\n" : "";
  text += stress_table(plan, result);
  return text + objections(comparison);
}

int stress(const StressOptions& options) {
  using enum OutputPath::Kind;
  CommandFiles files{
      {{"--json", options.json},
       {"--csv", options.csv, file},
       {.option = "--store", .path = options.store, .kind = file, .replaces = options.baseline},
       {"--pictures", options.pictures, folder},
       {"--save", options.save, corpus}}};
  if (!options.baseline.empty()) files.inputs.emplace_back(options.baseline);
  check_outputs(files);
  const StressPlan plan = plan_of(options);
  std::vector<StoredPoint> baseline;
  if (!options.baseline.empty()) baseline = read_breaking_points(options.baseline, plan);
  nlohmann::ordered_json stored;
  if (!options.store.empty()) stored = stored_before(options.store, plan);
  Interruption interruption;
  StressResult result;
  {
    const ProgressLine line;
    result = run_stress(plan, interruption, [&](const StressProgress& progress) {
      line.show(progress_line(progress));
    });
  }
  Interruption writing(kUntilSignal);
  const Comparison comparison = compare(plan, result, baseline);
  const std::string json =
      options.json.empty() ? "" : report_json(plan, result, comparison).dump(1, '\t') + '\n';
  const bool has_table = options.json != "-";
  if (!has_table) write_error(objections(comparison));
  const bool is_terse = leaves_out_tables({options.json, options.csv});
  const std::string text =
      is_terse ? objections(comparison) : report_text(plan, result, comparison);
  Outputs outputs;
  outputs.write(true, [&] { write_to_reader(has_table ? text : json); });
  write_files(plan, result, options, json, stored, writing, outputs);
  if (!outputs.are_written()) return 2;
  return comparison.worse.empty() && comparison.not_compared.empty() ? 0 : 1;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<StressOptions>();
  add_stress_options(app, *options);
  return [options] { return stress(*options); };
}

}  // namespace

extern const Command kStress;
const Command kStress{"stress", "Numerical stability: a knob turned until each collider breaks.",
                      "manifuzz stress --quick --sweep distance", define};

}  // namespace manifuzz
