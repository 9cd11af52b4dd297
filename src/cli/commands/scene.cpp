#include <algorithm>
#include <memory>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/names.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "corpus/corpus.hpp"
#include "corpus/output_check.hpp"
#include "report/picture/frame_picture.hpp"
#include "report/plot/gnuplot.hpp"
#include "report/scene_report.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kBodiesMax = 1'000'000;

/// Poses that a trajectory keeps: 20 bytes each.
constexpr std::size_t kPosesMax = 100'000'000;

/// A hundredth of a body.
constexpr double kMotion = 0.01;

/// Ten bodies.
constexpr double kMotionMax = 10;

struct Options {
  std::vector<std::string> scenes;
  std::vector<std::size_t> bodies;
  std::optional<std::uint64_t> steps;
  std::string mode = "strict";
  std::optional<double> motion;
  bool without_certificates = false;
  std::string json;
  std::string scaling;
  std::string skipped;
  std::string recycling;
  std::string frame;
  std::string save;

  /// Rising, each once.
  std::vector<std::size_t> sizes() const {
    if (bodies.empty()) return {100, 1'000, 10'000};
    const std::set<std::size_t> distinct(bodies.begin(), bodies.end());
    return {distinct.begin(), distinct.end()};
  }
  int steps_or_default() const { return static_cast<int>(steps.value_or(30)); }
  scene::Settings settings() const {
    const auto length = static_cast<float>(motion.value_or(kMotion));
    return {.recycled_motion = mode == "recycle" ? length : 0,
            .certificates = !without_certificates};
  }
};

std::vector<const SceneSpec*> chosen_scenes(const Options& options) {
  return chosen_by_name(scene_specs(), options.scenes, "scene", "--scene");
}

/// Each chosen scene at each number of bodies.
template <class Visit>
void for_each_scene(const Options& options, std::span<const std::size_t> sizes,
                    std::string_view doing, const Visit& visit) {
  const ProgressLine line;
  for (const SceneSpec* const spec : chosen_scenes(options)) {
    for (const std::size_t bodies : sizes) {
      line.show(fmt::format("{}: {} of {} bodies", doing, spec->name, bodies));
      visit(*spec, spec->make(bodies, options.steps_or_default()));
    }
  }
}

SceneReport run_all(const Options& options) {
  SceneReport report;
  const auto sizes = options.sizes();
  for_each_scene(options, sizes, "timing",
                 [&](const SceneSpec& spec, const Trajectory& trajectory) {
                   report.runs.push_back(run_scene(spec.name, trajectory, options.settings()));
                 });
  if (options.recycling.empty()) return report;
  const std::span<const std::size_t> first(sizes.data(), 1);
  for_each_scene(options, first, "recycling",
                 [&](const SceneSpec& spec, const Trajectory& trajectory) {
                   RecyclingCurve& curve = report.curves.emplace_back();
                   curve.scene = spec.name;
                   curve.bodies = trajectory.start.size();
                   curve.runs = run_recycling(trajectory);
                 });
  return report;
}

/// The last step of the first scene, at its least number of bodies.
std::string frame_of(const Options& options) {
  const SceneSpec& spec = *chosen_scenes(options).front();
  const std::size_t bodies = options.sizes().front();
  const Trajectory trajectory = spec.make(bodies, options.steps_or_default());
  const Frame frame = last_frame(trajectory, options.settings());
  std::vector<FramePoint> points;
  for (const scene::Contact& contact : frame.contacts) {
    const Pose<float>& a = frame.bodies[contact.a.index].pose;
    const Vector2<float> normal = rotate(a.rotation, contact.manifold.normal);
    for (int i = 0; i < contact.manifold.count; ++i) {
      const Vector2<float> position = transform(a, contact.manifold.points[i].position);
      points.push_back({position.cast<double>(), normal.cast<double>()});
    }
  }
  return frame_svg(frame.bodies, points, fmt::format("{} of {} bodies", spec.name, bodies));
}

/// A pair that mismatched is met in a scene by the tests from then on, as all of the corpus.
void save_findings(const std::string& folder, const std::vector<SceneRun>& runs) {
  for (const SceneRun& run : runs) {
    for (const PairCase& pair : run.afresh.findings) {
      CorpusCase finding;
      finding.pair = pair;
      finding.note = fmt::format("In the scene {} of {} bodies it was not as it is afresh.",
                                 run.scene, run.bodies);
      write_corpus_case(folder, finding);
    }
  }
}

/// What can be said before anything is run.
void expect_possible(const Options& options) {
  using enum OutputPath::Kind;
  check_outputs({{{"--json", options.json},
                  {"--save", options.save, corpus},
                  {"--frame", options.frame, file, {".svg"}},
                  {"--scaling", options.scaling, file, kPictureEndings},
                  {"--skipped", options.skipped, file, kPictureEndings},
                  {"--recycling", options.recycling, file, kPictureEndings}}});
  chosen_scenes(options);
  if (!options.scaling.empty() && options.sizes().size() < 2) {
    throw UserError("--scaling: needs two numbers of bodies or more");
  }
  if (options.motion && options.mode != "recycle") {
    throw UserError("--recycled-motion: needs --mode recycle");
  }
  if (options.motion && !(*options.motion > 0 && *options.motion <= kMotionMax)) {
    throw UserError(fmt::format("--recycled-motion: {} is not above 0 and at most {}",
                                *options.motion, kMotionMax));
  }
  const auto steps = static_cast<std::size_t>(options.steps_or_default());
  if (options.sizes().back() > kPosesMax / steps) {
    throw UserError(fmt::format("--bodies, --steps: {} bodies for {} steps are more than {} poses",
                                options.sizes().back(), steps, kPosesMax));
  }
}

void write_files(const Options& options, const SceneReport& report, const std::string& json,
                 Outputs& outputs) {
  outputs.write(!options.json.empty() && options.json != "-",
                [&] { write_file(options.json, json); });
  outputs.write(!options.save.empty(), [&] { save_findings(options.save, report.runs); });
  outputs.write(!options.frame.empty(), [&] { write_file(options.frame, frame_of(options)); });
  outputs.write(!options.scaling.empty(),
                [&] { write_line_plot(options.scaling, scaling_plot(report.runs)); });
  outputs.write(!options.skipped.empty(),
                [&] { write_skip_plot(options.skipped, skip_bars(report.runs)); });
  outputs.write(!options.recycling.empty(),
                [&] { write_line_plot(options.recycling, recycling_plot(report.curves)); });
}

/// What decides the status, alone.
std::string mismatches_in_words(const std::vector<SceneRun>& runs) {
  std::string text;
  for (const SceneRun& run : runs) {
    if (run.afresh.mismatches == 0) continue;
    text += fmt::format("{} of {} bodies: {} mismatches\n", run.scene, run.bodies,
                        run.afresh.mismatches);
  }
  return text;
}

int scene_command(const Options& options) {
  expect_possible(options);
  const SceneReport report = run_all(options);
  const std::string json = json_text(report_json(report));
  std::string tables = rows_table(report.runs);
  if (!report.curves.empty()) tables += '\n' + curves_table(report.curves);
  if (leaves_out_tables({options.json})) tables = mismatches_in_words(report.runs);
  Outputs outputs;
  outputs.write(true, [&] { write_to_reader(options.json == "-" ? json : tables); });
  write_files(options, report, json, outputs);
  if (!outputs.are_written()) return 2;
  const auto has_mismatch = [](const SceneRun& run) { return run.afresh.mismatches > 0; };
  return std::ranges::any_of(report.runs, has_mismatch) ? 1 : 0;
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
  app.add_option(
         "--mode", options->mode,
         "strict: contacts as colliding all pairs afresh gives them, bit for bit (checked, up to "
         "10000 bodies); recycle: "
         "touching pairs keep theirs, carried along; strict if not given")
      ->type_name("M")
      ->check(CLI::IsMember({"strict", "recycle"}));
  add_length(app, "--recycled-motion", options->motion,
             "how far a body may move before its contacts are not recycled; 0.01 if not given");
  app.add_flag("--without-certificates", options->without_certificates,
               "collide every pair that moved, whatever was proven");
  app.add_option("--json", options->json, "the rows as JSON, to a file or - for stdout")
      ->type_name("FILE");
  app.add_option("--save", options->save, "a corpus for pairs that are not as they are afresh")
      ->type_name("DIR");
  app.add_option("--scaling", options->scaling, "time against bodies, FILE.svg or FILE.png")
      ->type_name("FILE");
  app.add_option("--skipped", options->skipped, "where pairs went, by scene, FILE.svg or FILE.png")
      ->type_name("FILE");
  app.add_option("--recycling", options->recycling,
                 "what recycling costs at eight motions: pairs skipped against error, judged; "
                 "FILE.svg or FILE.png")
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
