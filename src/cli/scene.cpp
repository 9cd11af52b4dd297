#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/file.hpp"
#include "cases/user_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "kernel/target.hpp"
#include "measure/scene_run.hpp"
#include "report/frame_picture.hpp"
#include "report/gnuplot.hpp"
#include "report/provenance.hpp"
#include "report/scene_plots.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kBodiesMax = 1'000'000;

struct Options {
  std::vector<std::string> scenes;
  std::vector<std::size_t> bodies;
  std::optional<std::uint64_t> steps;
  std::string json;
  std::string scaling;
  std::string skipped;
  std::string frame;
};

std::vector<const SceneSpec*> chosen_scenes(const std::vector<std::string>& names) {
  std::vector<const SceneSpec*> chosen;
  for (const std::string& name : names) {
    chosen.push_back(find_scene(name));
    if (chosen.back() != nullptr) continue;
    std::string known;
    for (const SceneSpec& spec : scene_specs()) known += fmt::format(" {}", spec.name);
    throw UserError(fmt::format("--scene: there is no '{}'; there are{}", name, known));
  }
  if (!chosen.empty()) return chosen;
  for (const SceneSpec& spec : scene_specs()) chosen.push_back(&spec);
  return chosen;
}

std::vector<SceneRun> run_all(const Options& options) {
  const std::vector<std::size_t> sizes =
      options.bodies.empty() ? std::vector<std::size_t>{100, 1'000, 10'000} : options.bodies;
  const ProgressLine line;
  std::vector<SceneRun> runs;
  for (const SceneSpec* const spec : chosen_scenes(options.scenes)) {
    for (const std::size_t bodies : sizes) {
      line.show(fmt::format("{} of {} bodies", spec->name, bodies));
      const int steps = static_cast<int>(options.steps.value_or(30));
      runs.push_back(run_scene(spec->name, spec->make(bodies, steps)));
    }
  }
  return runs;
}

/// The runs of one scene, which follow each other.
std::vector<ScalingLine> scaling_lines(const std::vector<SceneRun>& runs) {
  std::vector<ScalingLine> lines;
  for (const SceneRun& run : runs) {
    if (lines.empty() || lines.back().name != run.scene) lines.push_back({run.scene, {}});
    lines.back().points.emplace_back(static_cast<double>(run.bodies), run.ns_per_step);
  }
  for (ScalingLine& line : lines) {
    const auto exponent = fitted_exponent(line.points);
    if (exponent) line.name += fmt::format(", exponent {:.2f}", *exponent);
  }
  return lines;
}

/// Of each scene the run of the most bodies.
std::vector<SkipBar> skip_bars(const std::vector<SceneRun>& runs) {
  std::vector<SkipBar> bars;
  for (const SceneRun& run : runs) {
    if (bars.empty() || bars.back().name != run.scene) bars.emplace_back();
    const scene::PairCounts& pairs = run.counts.pairs;
    const auto all = static_cast<double>(std::max<std::size_t>(1, pairs.candidates));
    const auto percent = [&](std::size_t part) { return 100 * static_cast<double>(part) / all; };
    bars.back() = {run.scene, percent(pairs.at_rest), percent(pairs.separated),
                   percent(pairs.collided)};
  }
  return bars;
}

/// The last step of the first scene, at its first number of bodies.
std::string frame_of(const Options& options) {
  const SceneSpec& spec = *chosen_scenes(options.scenes).front();
  const std::size_t bodies = options.bodies.empty() ? 100 : options.bodies.front();
  const Trajectory trajectory = spec.make(bodies, static_cast<int>(options.steps.value_or(30)));
  const Frame frame = last_frame(trajectory);
  return frame_svg(frame.bodies, frame.contacts, fmt::format("{} of {} bodies", spec.name, bodies));
}

nlohmann::ordered_json report_json(const std::vector<SceneRun>& runs) {
  nlohmann::ordered_json json = provenance(1, {});
  json["machine"]["instruction_set"] = kernel::targets().front();
  json["rows"] = nlohmann::ordered_json::array();
  for (const SceneRun& run : runs) json["rows"].push_back(row_json(run));
  json["exponents"] = nlohmann::ordered_json::object();
  for (const ScalingLine& line : scaling_lines(runs)) {
    const auto exponent = fitted_exponent(line.points);
    if (exponent) json["exponents"][line.name.substr(0, line.name.find(','))] = *exponent;
  }
  return json;
}

int scene_command(const Options& options) {
  for (const std::string& picture : {options.scaling, options.skipped}) {
    if (!picture.empty()) expect_plot_name(picture);
  }
  const std::vector<SceneRun> runs = run_all(options);
  const std::string text = report_json(runs).dump(2) + '\n';
  if (!options.scaling.empty()) write_scaling_plot(options.scaling, scaling_lines(runs));
  if (!options.skipped.empty()) write_skip_plot(options.skipped, skip_bars(runs));
  if (!options.frame.empty()) write_file(options.frame, frame_of(options));
  if (!options.json.empty() && options.json != "-") write_file(options.json, text);
  write_to_reader(options.json == "-" ? text : rows_table(runs));
  return std::ranges::any_of(runs,
                             [](const SceneRun& run) { return run.mismatches.value_or(0) > 0; })
             ? 1
             : 0;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("--scene", options->scenes, "one to go through, again for more; all if not given")
      ->type_name("S")
      ->allow_extra_args(false);
  app.add_option("--bodies", options->bodies,
                 "how many, 10 to 1000000, again for more; 100, 1000 and 10000 if not given")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{10}, kBodiesMax))
      ->allow_extra_args(false);
  add_whole_number(app, "--steps", options->steps, "how many; 30 if not given", 1)
      ->check(CLI::Range(1, 100'000));
  app.add_option("--json", options->json, "the rows as JSON, to a file or - for stdout")
      ->type_name("FILE");
  app.add_option("--scaling", options->scaling, "time against bodies, FILE.svg or FILE.png")
      ->type_name("FILE");
  app.add_option("--skipped", options->skipped, "where pairs went, by scene, FILE.svg or FILE.png")
      ->type_name("FILE");
  app.add_option("--frame", options->frame, "the first scene's last step with its contacts, as SVG")
      ->type_name("FILE");
  return [options] { return scene_command(*options); };
}

}  // namespace

extern const Command kScene;
const Command kScene{"scene", "Whole scenes step after step, against Box2D's contact manager.",
                     "manifuzz scene --scene resting_pile --bodies 1000 --steps 20", define};

}  // namespace manifuzz
