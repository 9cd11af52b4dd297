#include "measure/bench/bench.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "engines/asked_engines.hpp"
#include "engines/colliders.hpp"
#include "engines/sequence_colliders.hpp"
#include "external/external_collider.hpp"
#include "report/measurements/measurements.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

struct BenchArguments {
  std::optional<std::uint64_t> seed;
  std::vector<std::string> regimes;
  std::vector<std::string> colliders;
  bool quick = false;
  bool methods = false;
  std::string json;
  std::vector<std::string> pictures;
};

BenchSubject subject_of(const TimedPass& pass) {
  return {.name = std::string(pass.name), .prepare = pass.prepare, .collider = [&pass] {
            return find_collider(pass.collider);
          }};
}

/// The passes of engines that this build has.
std::vector<const TimedPass*> engine_passes() {
  std::vector<const TimedPass*> all;
  for (const Engine& engine : built_engines()) {
    for (const TimedPass& pass : engine.passes) {
      if (find_installed(std::string(pass.collider))) all.push_back(&pass);
    }
  }
  return all;
}

/// A shared library in this process, its errors as they are where it is asked safely.
BenchSubject library(const std::string& name, const std::string& path) {
  return {.name = name,
          .prepare = [path](std::span<const PairCase> pairs) { return library_pass(path, pairs); },
          .collider = [path] { return collider_in_process(path); },
          .is_library = true};
}

/// The libraries among these names, by name or path, which are taken out; behind an empty one.
std::vector<BenchSubject> take_libraries(std::vector<std::string>& names) {
  std::vector<BenchSubject> all;
  std::erase_if(names, [&all](const std::string& name) {
    const auto path = library_of_installed(name);
    if (path) {
      all.push_back(library(name, *path));
    } else if (name.ends_with(".so")) {
      all.push_back(library(Library(name).declaration().name, name));
    } else {
      return false;
    }
    return true;
  });
  if (all.empty()) return all;
  all.insert(all.begin(),
             {.name = std::string(kInterface), .prepare = interface_pass, .is_library = true});
  return all;
}

/// The libraries' colliders whose worlds, of the same names, scenes are held against.
std::vector<std::string> installed_baselines() {
  std::vector<std::string> names;
  for (const EngineTimedWorld& world : installed_timed_worlds()) {
    if (find_asked(world.name)) names.push_back(world.name);
  }
  return names;
}

/// The engine to whose time the others' are ratios, and those that are named.
std::vector<BenchSubject> chosen_subjects(std::vector<std::string> names) {
  const bool is_all = names.empty();
  if (is_all) names = installed_baselines();
  std::vector<BenchSubject> libraries = take_libraries(names);
  std::vector<BenchSubject> all;
  for (const TimedPass* const pass : engine_passes()) all.push_back(subject_of(*pass));
  std::ranges::move(own_subjects(), std::back_inserter(all));
  std::set<std::string> wanted{std::string(kRatioBase)};
  if (is_all || !names.empty()) {
    for (const BenchSubject* const one : chosen_by_name(all, names, "collider", "--collider")) {
      wanted.insert(one->name);
    }
  }
  std::erase_if(all, [&](const BenchSubject& one) { return !wanted.contains(one.name); });
  std::ranges::move(libraries, std::back_inserter(all));
  return all;
}

/// The methods of engines, as far as this build has them.
std::vector<MethodSubject> methods_of_engines() {
  std::vector<MethodSubject> all;
  for (const TimedPass* const pass : engine_passes()) {
    if (!pass->method.empty()) all.push_back({std::string(pass->method), subject_of(*pass)});
  }
  for (const Engine& engine : built_engines()) {
    for (const SequenceColliderEntry& keeper : engine.keepers) {
      all.push_back({"points kept", {.name = std::string(keeper.name)}, keeper.make});
    }
  }
  return all;
}

/// Ours and the engines', each of a way beside the others of it.
std::vector<MethodSubject> all_methods() {
  std::vector<MethodSubject> all;
  for (const auto& some : {own_methods(), methods_of_engines()}) {
    for (const MethodSubject& one : some) {
      const auto last =
          std::ranges::find(all.rbegin(), all.rend(), one.method, &MethodSubject::method);
      all.insert(last.base() == all.begin() ? all.end() : last.base(), one);
    }
  }
  return all;
}

MethodsOptions quick_methods() {
  return {.judged = 500, .sequences = 40, .timing = {.repetitions = 3, .repetition_seconds = 0.01}};
}

/// Prints and writes what a run gave: its table, its rows and its pictures.
int write_results(const BenchArguments& options, const nlohmann::ordered_json& json,
                  const std::string& table,
                  const std::function<void(const std::string& path)>& draw) {
  Outputs outputs;
  write_table(outputs, leaves_out_tables(options.json) ? "" : machine_line(json) + table,
              options.json, json_text(json));
  for (const std::string& picture : options.pictures) {
    outputs.write(true, [&] { draw(picture); });
  }
  return outputs.are_written() ? 0 : 2;
}

int bench_methods(const BenchArguments& options) {
  const std::vector<MethodSubject> subjects = all_methods();
  MethodsOptions how = options.quick ? quick_methods() : MethodsOptions{};
  how.seed = options.seed.value_or(how.seed);
  const std::vector<MethodRow> rows = [&] {
    const ProgressLine line;
    return run_methods(subjects, how, [&](std::size_t w) {
      line.show(fmt::format("workload {} of {}", w + 1, method_workload_count()));
    });
  }();
  return write_results(options, methods_json(rows, subjects, how.seed), methods_table(rows),
                       [&](const std::string& path) { write_methods_plot(path, rows); });
}

int bench(const BenchArguments& options) {
  CommandFiles files{{{"--json", options.json}}};
  for (const std::string& picture : options.pictures) {
    files.outputs.push_back({"--picture", picture, OutputPath::Kind::file, kPictureEndings});
  }
  check_outputs(files);
  if (options.methods) return bench_methods(options);
  const std::vector<BenchSubject> subjects = chosen_subjects(options.colliders);
  const auto chosen = chosen_by_name(regimes(), options.regimes, "regime", "--regime");
  const auto workloads = options.quick ? std::vector{usual_workload()} : all_workloads(chosen);
  BenchOptions how = options.quick ? quick_bench() : BenchOptions{};
  how.seed = options.seed.value_or(how.seed);
  const std::vector<BenchRow> rows = [&] {
    const ProgressLine line;
    return run_bench(subjects, workloads, how, [&](std::size_t w) {
      line.show(fmt::format("workload {} of {}", w + 1, workloads.size()));
    });
  }();
  return write_results(options, bench_json(rows, subjects, how.seed), bench_table(rows),
                       [&](const std::string& path) { write_bench_plot(path, rows); });
}

void add_bench_arguments(CLI::App& app, BenchArguments& options) {
  add_whole_number(app, "--seed", options.seed, "random seed; default: 1");
  CLI::Option* const collider =
      app.add_option(
             "--collider", options.colliders,
             fmt::format(
                 "collider to time besides {}; repeatable; default: all, of shared libraries "
                 "those that are baselines of scene",
                 kRatioBase))
          ->type_name("C|LIBRARY.so")
          ->allow_extra_args(false);
  CLI::Option* const regime =
      app.add_option("--regime", options.regimes,
                     "regime to measure besides generic; repeatable; default: all")
          ->type_name("R")
          ->allow_extra_args(false);
  app.add_flag("--quick", options.quick, "measure only the usual workload, in less than 30 s")
      ->excludes(regime);
  add_json(app, options.json, "the rows");
  app.add_flag("--methods", options.methods,
               "compare clipping with the article's other methods, over pairs and over frames")
      ->excludes(collider)
      ->excludes(regime);
  app.add_option("--picture", options.pictures,
                 "draw run time against error, or with --methods the trade-offs between methods; "
                 "repeatable")
      ->type_name("FILE.svg|FILE.png")
      ->allow_extra_args(false);
}

}  // namespace

Run define_bench(CLI::App& app) {
  return define<BenchArguments, add_bench_arguments, bench>(app);
}

}  // namespace manifuzz
