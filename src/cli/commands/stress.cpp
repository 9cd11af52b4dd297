#include "measure/stress/stress.hpp"

#include <algorithm>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"
#include "report/measurements/measurements.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kQuickCases = 600;
constexpr std::uint64_t kQuickFrames = 10'000;

struct StressArguments {
  std::vector<std::string> sweeps;
  std::vector<std::string> colliders;
  ColliderChoice program{"collider", "", ""};
  ExternalOptions outside;
  std::optional<std::uint64_t> cases;
  std::optional<std::uint64_t> frames;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> jobs;
  bool quick = false;
  bool flush_to_zero = false;
  std::string json;
  std::string pictures;
  std::string save;
  std::string baseline;
  std::string store;
};

/// The colliders that are named, or every linked one that is there.
std::vector<StressSubject> chosen_subjects(const StressArguments& options) {
  std::vector<StressSubject> chosen;
  const auto add = [&chosen](const Collider& collider) {
    const ColliderEntry* const entry = find_entry(collider.declaration.name);
    const bool is_ours = entry != nullptr && entry->is_ours;
    chosen.push_back({collider.declaration.name, collider, false, is_ours});
  };
  for (const std::string& name : options.colliders) {
    add(find_collider(ColliderChoice{"collider", name, ""}, options.outside));
  }
  if (!options.program.command.empty()) add(find_collider(options.program, options.outside));
  if (!chosen.empty()) return chosen;
  for (const ColliderEntry& entry : linked_colliders()) {
    try {
      const Collider collider = entry.make();
      if (!options.quick || !collider.is_isolated()) add(collider);
    } catch (const UserError& error) {
      write_remark(fmt::format("left out: {}", error.what()));
    }
  }
  return chosen;
}

StressPlan plan_of(const StressArguments& options) {
  StressPlan plan;
  choose_sweeps(options.sweeps, "--sweep", plan);
  plan.subjects = with_variants(chosen_subjects(options));
  plan.seed = options.seed.value_or(plan.seed);
  plan.cases = options.cases.value_or(options.quick ? kQuickCases : plan.cases);
  plan.flush_to_zero = options.flush_to_zero;
  if (plan.flush_to_zero && !can_flush_to_zero()) {
    throw UserError("--flush-to-zero: not supported on this processor; omit the option");
  }
  plan.frames = options.frames.value_or(options.quick ? kQuickFrames : plan.frames);
  const std::uint64_t cores = std::max(1U, std::thread::hardware_concurrency());
  plan.jobs = static_cast<int>(std::min<std::uint64_t>(options.jobs.value_or(cores), 1024));
  return plan;
}

StressResult run(const StressPlan& plan, Interruption& interruption) {
  const ProgressLine line;
  return run_stress(plan, interruption,
                    [&](const StressProgress& progress) { line.show(progress_line(progress)); });
}

void save(const StressPlan& plan, const StressResult& result, const std::string& folder,
          Interruption& interruption) {
  const ProgressLine line;
  try {
    save_worst(
        plan, result, kept_path(folder), interruption,
        [&](const std::string& name) { line.show("saving " + name); },
        [](const std::filesystem::path& file) {
          write_error(fmt::format("{} is worse than what this run found, and is kept\n",
                                  printable_path(file)));
        });
  } catch (const Interrupted&) {
    throw UserError("--save: interrupted; not all cases were saved");
  }
}

/// What a run found is written, even after it was interrupted; another signal ends the writing.
void write_files(const StressPlan& plan, const StressResult& result, const StressArguments& options,
                 const nlohmann::ordered_json& stored, Interruption& interruption,
                 Outputs& outputs) {
  outputs.write(!options.store.empty(), [&] {
    if (result.interrupted) throw UserError("--store: interrupted; nothing was stored");
    write_file(options.store, breaking_points_json(plan, result, stored).dump(1, '\t') + '\n');
  });
  outputs.write(!options.save.empty(), [&] { save(plan, result, options.save, interruption); });
  if (options.pictures.empty()) return;
  for (const Sweep* const sweep : plan.sweeps) {
    const bool is_cut_short = interruption.is_stopped();
    outputs.write(true, [&] {
      if (is_cut_short) throw UserError("--pictures: interrupted; not all pictures were drawn");
      write_stress_pictures(options.pictures, plan, result, *sweep);
    });
    if (is_cut_short) return;
  }
}

int stress(const StressArguments& options) {
  using enum OutputPath::Kind;
  CommandFiles files{
      {{"--json", options.json},
       {.option = "--store", .path = options.store, .kind = file, .replaces = options.baseline},
       {"--pictures", options.pictures, folder},
       {"--save", options.save, corpus}}};
  if (!options.baseline.empty()) files.inputs.emplace_back(options.baseline);
  check_outputs(files);
  const StressPlan plan = plan_of(options);
  for (const Sweep* const sweep : plan.sweeps) {
    for (const std::string& picture : stress_picture_files(options.pictures, *sweep)) {
      if (options.pictures.empty() || is_apart({"--pictures", picture, file}, files)) continue;
      throw UserError(
          fmt::format("--pictures: {} is another output or an input; name another folder",
                      printable(picture, 200)));
    }
  }
  std::vector<StoredPoint> baseline;
  if (!options.baseline.empty()) baseline = read_breaking_points(options.baseline, plan);
  nlohmann::ordered_json stored;
  if (!options.store.empty()) stored = stored_before(options.store, plan);
  Interruption interruption;
  const StressResult result = run(plan, interruption);
  Interruption writing(kUntilSignal);
  const Comparison comparison = compare(plan, result, baseline);
  const nlohmann::ordered_json json = stress_json(plan, result, comparison);
  std::string text = complaints(comparison);
  if (options.json == "-") write_error(text);
  if (!leaves_out_tables(options.json)) text = stress_table(plan, result) + text;
  Outputs outputs;
  write_table(outputs, text, options.json, json.dump(1, '\t') + '\n');
  write_files(plan, result, options, stored, writing, outputs);
  if (!outputs.are_written()) return 2;
  return comparison.worse.empty() && comparison.not_compared.empty() ? 0 : 1;
}

void add_run(CLI::App& app, StressArguments& options) {
  app.add_option("--sweep", options.sweeps, "sweep or walk to run; repeatable; default: all")
      ->type_name("S")
      ->allow_extra_args(false);
  app.add_option("--collider", options.colliders,
                 "collider to measure; repeatable; default: all that this build has")
      ->type_name("C|LIBRARY.so")
      ->allow_extra_args(false);
  add_text(
      app, "--collider-command", options.program.command, "COMMAND",
      "one more collider, as a program that reads cases and writes manifolds, a JSON line each");
  add_external_options(app, options.outside);
  add_whole_number(app, "--cases", options.cases,
                   "number of cases in each step of a sweep; default: 100000", 1);
  add_whole_number(app, "--frames", options.frames,
                   "number of frames in each walk; default: 1000000", 1);
  add_whole_number(app, "--seed", options.seed, "random seed; default: 1");
  add_whole_number(app, "--jobs", options.jobs, "number of worker processes; default: one per core",
                   1);
  app.add_flag(
      "--quick", options.quick,
      "measure fewer cases, and colliders in their own processes only if named: less than 20 s");
  app.add_flag("--flush-to-zero", options.flush_to_zero,
               "flush subnormal numbers to zero in this process, as some engines do");
}

void add_outputs(CLI::App& app, StressArguments& options) {
  add_json(app, options.json, "every step");
  add_text(app, "--pictures", options.pictures, "DIR",
           "draw error against the parameter of each sweep, as DIR/SWEEP.svg and DIR/SWEEP.png");
  add_text(app, "--save", options.save, "DIR",
           "folder for the worst cases: wrong ones, shrunk, and clip's worst of every sweep");
  add_text(app, "--baseline", options.baseline, "FILE",
           "stored breaking points; fail if one has moved down");
  add_text(app, "--store", options.store, "FILE",
           "store the breaking points for --baseline; those in the file are replaced");
}

void add_stress_arguments(CLI::App& app, StressArguments& options) {
  add_run(app, options);
  add_outputs(app, options);
}

}  // namespace

Run define_stress(CLI::App& app) {
  return define<StressArguments, add_stress_arguments, stress>(app);
}

}  // namespace manifuzz
