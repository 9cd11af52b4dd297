#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "report/measurements/measurements.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kBodiesMax = 1'000'000;

/// Poses that a trajectory keeps: 20 bytes each.
constexpr std::size_t kPosesMax = 100'000'000;

constexpr std::size_t kThreadsMax = 256;

constexpr double kMotion = 0.01;  ///< a hundredth of a body
constexpr double kMotionMax = 10;

struct SceneArguments {
  std::vector<std::string> scenes;
  std::vector<std::size_t> bodies{100, 1'000, 10'000};
  std::optional<std::uint64_t> steps;
  std::string mode = "strict";
  std::optional<double> motion;
  bool without_certificates = false;
  std::size_t threads = 1;
  std::string json;
  std::string scaling;
  std::string skipped;
  std::string recycling;
  std::string frame;
  std::string save;
};

ScenePlan plan_of(const SceneArguments& options) {
  const std::set<std::size_t> sizes(options.bodies.begin(), options.bodies.end());
  ScenePlan plan{.scenes = chosen_by_name(scene_specs(), options.scenes, "scene", "--scene"),
                 .sizes = {sizes.begin(), sizes.end()},
                 .settings = {.certificates = !options.without_certificates},
                 .threads = options.threads,
                 .has_curves = !options.recycling.empty()};
  plan.steps = static_cast<int>(options.steps.value_or(plan.steps));
  if (options.mode == "recycle") {
    plan.settings.recycled_motion = static_cast<float>(options.motion.value_or(kMotion));
  }
  return plan;
}

/// What can be said before anything is run.
void expect_possible(const SceneArguments& options, const ScenePlan& plan) {
  using enum OutputPath::Kind;
  check_outputs({{{"--json", options.json},
                  {"--save", options.save, corpus},
                  {"--frame", options.frame, file, {".svg"}},
                  {"--scaling", options.scaling, file, kPictureEndings},
                  {"--skipped", options.skipped, file, kPictureEndings},
                  {"--recycling", options.recycling, file, kPictureEndings}}});
  if (!options.scaling.empty() && plan.sizes.size() < 2) {
    throw UserError("--scaling: needs two numbers of bodies or more");
  }
  if (options.threads > 1 && options.mode == "recycle") {
    throw UserError("--threads: only --mode strict runs on several threads");
  }
  if (options.motion && options.mode != "recycle") {
    throw UserError("--recycled-motion: needs --mode recycle");
  }
  if (options.motion &&
      !(static_cast<float>(*options.motion) > 0 && *options.motion <= kMotionMax)) {
    throw UserError(fmt::format("--recycled-motion: {} is out of range; use more than 0, up to {}",
                                *options.motion, kMotionMax));
  }
  if (plan.sizes.back() > kPosesMax / static_cast<std::size_t>(plan.steps)) {
    throw UserError(
        fmt::format("--bodies, --steps: {} bodies for {} steps are more than {} poses; use fewer",
                    plan.sizes.back(), plan.steps, kPosesMax));
  }
}

int scene_command(const SceneArguments& options) {
  const ScenePlan plan = plan_of(options);
  expect_possible(options, plan);
  const SceneResult result = [&] {
    const ProgressLine line;
    return run_scenes(plan, [&](std::string_view doing, std::string_view scene, std::size_t n) {
      line.show(fmt::format("{}: {} of {} bodies", doing, scene, n));
    });
  }();
  const std::string mismatches = mismatches_in_words(result.runs);
  const std::string text = leaves_out_tables(options.json) ? mismatches : scene_table(result);
  Outputs outputs;
  write_table(outputs, text, options.json, json_text(scene_json(result)));
  outputs.write(!options.save.empty(), [&] { save_mismatches(options.save, result.runs); });
  outputs.write(!options.frame.empty(), [&] { write_file(options.frame, scene_frame(plan)); });
  outputs.write(!options.scaling.empty(),
                [&] { write_plot(options.scaling, scaling_plot(result.runs)); });
  outputs.write(!options.skipped.empty(),
                [&] { write_skipped_plot(options.skipped, result.runs); });
  outputs.write(!options.recycling.empty(),
                [&] { write_plot(options.recycling, recycling_plot(result.curves)); });
  if (!outputs.are_written()) return 2;
  return mismatches.empty() ? 0 : 1;
}

void add_scene_arguments(CLI::App& app, SceneArguments& options) {
  const auto add = [&app](const char* name, auto& to, const char* type, const char* what) {
    return app.add_option(name, to, what)->type_name(type);
  };
  add("--scene", options.scenes, "S", "scene to run; repeatable; default: all")
      ->allow_extra_args(false);
  add("--bodies", options.bodies, "N",
      "number of bodies, 10 to 1000000; repeatable; default: 100, 1000 and 10000")
      ->check(CLI::Range(std::size_t{10}, kBodiesMax))
      ->allow_extra_args(false);
  add_whole_number(app, "--steps", options.steps, "number of steps; default: 30", 1)
      ->check(CLI::Range(1, 100'000));
  add("--mode", options.mode, "M",
      "strict: the contacts equal those of a fresh collision of all pairs, bit for bit (checked up "
      "to 10000 bodies); recycle: touching pairs reuse last step's contacts; default: strict")
      ->check(CLI::IsMember({"strict", "recycle"}));
  add_length(
      app, "--recycled-motion", options.motion,
      "with --mode recycle, how far a body may move while its contacts are reused; default: 0.01");
  app.add_flag("--without-certificates", options.without_certificates,
               "collide every pair that moved, even where its contacts are proven to be the same");
  add("--threads", options.threads, "N",
      "number of threads that a step runs on, the contacts being those of one; default: 1")
      ->check(CLI::Range(std::size_t{1}, kThreadsMax));
  add_json(app, options.json, "the rows");
  add("--save", options.save, "DIR",
      "folder for pairs whose contacts differ from a fresh collision, saved as cases");
  add("--scaling", options.scaling, "FILE.svg|FILE.png", "draw time against number of bodies");
  add("--skipped", options.skipped, "FILE.svg|FILE.png",
      "draw for each scene why pairs were skipped, and how many were computed");
  add("--recycling", options.recycling, "FILE.svg|FILE.png",
      "draw the share of pairs that recycling skips against the judged error, for eight limits of "
      "motion");
  add("--frame", options.frame, "FILE.svg",
      "draw the last step of the first scene with its contacts");
}

}  // namespace

Run define_scene(CLI::App& app) {
  return define<SceneArguments, add_scene_arguments, scene_command>(app);
}

}  // namespace manifuzz
