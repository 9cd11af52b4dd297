#include "measure/bench/bench.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file.hpp"
#include "base/names.hpp"
#include "base/user_error.hpp"
#include "cli/bench_subjects.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "corpus/output_check.hpp"
#include "kernel/target.hpp"
#include "measure/provenance.hpp"
#include "report/plot/gnuplot.hpp"
#include "report/plot/plot.hpp"

namespace manifuzz {
namespace {

/// Pairs a workload: what each takes in all fits the first cache, the second, or neither.
constexpr std::size_t kPairsInL1 = 64;
constexpr std::size_t kPairsInL2 = 1024;
constexpr std::size_t kPairsInMemory = 65'536;

struct Options {
  std::optional<std::uint64_t> seed;
  std::vector<std::string> regimes;
  std::vector<std::string> colliders;
  bool quick = false;
  std::string json;
  std::string csv;
  std::vector<std::string> pictures;
};

/// The usual one first: mixed counts, half touching.
std::vector<WorkloadSpec> workloads_of(const Options& options) {
  std::vector<WorkloadSpec> specs;
  const Regime* const generic = find_regime("generic");
  specs.push_back({generic, {}, 0.5, kPairsInL2});
  if (options.quick) return specs;
  for (const int vertices : {3, 4, 6, 8}) specs.push_back({generic, vertices, 0.5, kPairsInL2});
  for (const double touching : {0.0, 0.1, 1.0}) {
    specs.push_back({generic, {}, touching, kPairsInL2});
  }
  for (const std::size_t pairs : {kPairsInL1, kPairsInMemory}) {
    specs.push_back({generic, {}, 0.5, pairs});
  }
  for (const Regime* const regime :
       chosen_by_name(regimes(), options.regimes, "regime", "--regime")) {
    if (regime != generic) specs.push_back({regime, {}, 0.5, kPairsInL2});
  }
  return specs;
}

std::vector<BenchSubject> chosen_contenders(const std::vector<std::string>& names) {
  std::vector<BenchSubject> all = bench_subjects();
  std::set<std::string> wanted{std::string(kPaceMaker)};
  for (const BenchSubject* const one : chosen_by_name(all, names, "collider", "--collider")) {
    wanted.insert(one->name);
  }
  std::erase_if(all, [&](const BenchSubject& one) { return !wanted.contains(one.name); });
  return all;
}

BenchOptions bench_options(const Options& options) {
  BenchOptions bench;
  bench.seed = options.seed.value_or(1);
  if (options.quick) {
    bench.judged = 5'000;
    bench.timing = {.repetitions = 7, .repetition_seconds = 0.01};
  }
  return bench;
}

/// Run time against error over the first workload, a point for each that gives manifolds.
Plot plot_of(const std::vector<BenchRow>& rows) {
  Plot plot{.title = "Run time against error: mixed polygons, half of the pairs touching",
            .x_label = "ns a pair",
            .y_label = "depth error, 99.9%, in 2^-24 of the extent",
            .points = {}};
  const std::string widest = kernel::targets().front();
  for (const BenchRow& row : rows) {
    const BenchSubject& subject = *row.subject;
    const bool is_widest = subject.target.empty() || subject.target == widest;
    const bool is_hinted = subject.name.ends_with("+hint");
    if (row.workload > 0 || !row.errors || !is_widest || is_hinted) continue;
    const std::string how = subject.input == "pair" ? "" : ", " + subject.input;
    plot.points.push_back({subject.name + how, row.timing.ns_per_pair, row.errors->depth.p999});
  }
  return plot;
}

nlohmann::ordered_json report_json(const std::vector<BenchRow>& rows,
                                   const std::vector<BenchSubject>& ran, std::uint64_t seed) {
  std::vector<Declaration> declarations;
  for (const BenchSubject& subject : ran) {
    if (subject.collider) declarations.push_back(subject.collider().declaration);
  }
  nlohmann::ordered_json json = provenance(seed, declarations);
  json["machine"]["instruction_set"] = kernel::targets().front();
  json["rows"] = nlohmann::ordered_json::array();
  for (const BenchRow& row : rows) json["rows"].push_back(row_json(row));
  return json;
}

int bench(const Options& options) {
  CommandFiles files{{{"--json", options.json}, {"--csv", options.csv, OutputPath::Kind::file}}};
  for (const std::string& picture : options.pictures) {
    files.outputs.push_back({"--picture", picture, OutputPath::Kind::file, kPictureEndings});
  }
  check_outputs(files);
  const std::vector<BenchSubject> ran = chosen_contenders(options.colliders);
  const std::vector<WorkloadSpec> workloads = workloads_of(options);
  const BenchOptions how = bench_options(options);
  const std::vector<BenchRow> rows = [&] {
    const ProgressLine line;
    return run_bench(ran, workloads, how, [&](std::size_t w) {
      line.show(fmt::format("workload {} of {}", w + 1, workloads.size()));
    });
  }();
  kernel::use_target(kernel::targets().front());
  const nlohmann::ordered_json json = report_json(rows, ran, how.seed);
  const std::string text = json_text(json);
  if (!options.csv.empty()) write_file(options.csv, rows_csv(rows));
  if (!options.json.empty() && options.json != "-") write_file(options.json, text);
  const std::string machine =
      fmt::format("{}, {}\n\n", json["machine"]["processor"].get<std::string>(),
                  json["compiler"].get<std::string>());
  if (!leaves_out_tables({options.json, options.csv})) {
    write_to_reader(options.json == "-" ? text : machine + rows_table(rows));
  }
  for (const std::string& picture : options.pictures) write_plot(picture, plot_of(rows));
  return 0;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  add_whole_number(app, "--seed", options->seed, "what the cases depend on; 1 if not given");
  app.add_option("--collider", options->colliders,
                 "one to time besides box2d, again for more; all if not given")
      ->type_name("C")
      ->allow_extra_args(false);
  CLI::Option* const regime =
      app.add_option("--regime", options->regimes,
                     "a regime besides generic, again for more; all if not given")
          ->type_name("R")
          ->allow_extra_args(false);
  app.add_flag("--quick", options->quick, "the usual workload alone, in less than 30 s")
      ->excludes(regime);
  app.add_option("--json", options->json, "the rows as JSON, to a file or - for stdout")
      ->type_name("FILE");
  app.add_option("--csv", options->csv, "the rows with commas")->type_name("FILE");
  app.add_option("--picture", options->pictures,
                 "run time against error, FILE.svg or FILE.png, again for another")
      ->type_name("FILE")
      ->allow_extra_args(false);
  return [options] { return bench(*options); };
}

}  // namespace

extern const Command kBench;
const Command kBench{"bench", "Run time against error, for every collider in one run.",
                     "manifuzz bench --quick --picture bench.svg", define};

}  // namespace manifuzz
