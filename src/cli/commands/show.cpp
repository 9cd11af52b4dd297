#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "campaign/in_child.hpp"
#include "campaign/neighbourhood_run.hpp"
#include "cli/case_argument.hpp"
#include "cli/collider_options.hpp"
#include "cli/commands.hpp"
#include "cli/judged.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/output_check.hpp"
#include "report/case_text.hpp"
#include "report/picture/case_picture.hpp"
#include "report/picture/map_picture.hpp"
#include "report/picture/map_words.hpp"
#include "report/picture/text_picture.hpp"
#include "report/upstream.hpp"

namespace manifuzz {
namespace {

/// Farther than this the map would be wider than any polygon.
constexpr std::uint64_t kMapStepMax = 100'000;

struct Options {
  CaseArgument given;
  ComparedColliders parties{{"subject", "", ""}, {"oracle", "", ""}, {}};
  std::string svg;
  bool upstream = false;
  bool text_picture = false;
  std::optional<std::string> map;
  std::optional<std::uint64_t> map_step;
};

/// What was asked for, else what the case names, else the usual one.
ColliderChoice chosen(const std::string& file, ColliderChoice asked, const std::string& recorded,
                      const char* usual) {
  if (!asked.name.empty() || !asked.command.empty()) return asked;
  asked.name = recorded.empty() ? usual : recorded;
  if (is_findable(asked.name)) return asked;
  throw UserError(
      fmt::format("{}: was found with '{}' from outside; say where that is: --{} ./LIBRARY.so or "
                  "--{}-command PROGRAM",
                  file, printable(asked.name), asked.role, asked.role));
}

void check_map(const Options& options) {
  if (options.map_step && !options.map) {
    throw UserError("--map-step: there is no map without --map FILE.png");
  }
  if (options.map_step.value_or(1) > kMapStepMax) {
    throw UserError(fmt::format("--map-step: {} ulps are too many; take 1 to {}", *options.map_step,
                                kMapStepMax));
  }
}

/// Draws the map to its file and says in words what it comes to.
std::string write_map(const Options& options, const JudgedCase& judged, const Collider& subject,
                      const Collider& oracle, Interruption& interruption) {
  const Grid grid =
      grid_around(exact::Truth(judged.given.pair), static_cast<int>(options.map_step.value_or(1)));
  const Neighbourhood map =
      ask_neighbourhood(judged.given.pair, subject, oracle, grid, grid.cell_count(), interruption);
  if (interruption.is_stopped()) throw Interrupted();
  write_file(*options.map, map_png(judged, map));
  return fmt::format("map: {}\n  {}\n", grid_in_words(grid), severity_in_words(judged, map));
}

int show(const Options& options) {
  check_map(options);
  const std::string file = case_file(options.given);
  check_outputs({{{"--svg", options.svg},
                  {"--map", options.map.value_or(""), OutputPath::Kind::file, {".png"}}},
                 {file}});
  const CorpusCase given = read_case_file(file);
  const Expectation recorded = given.expect.value_or(Expectation{});
  ComparedColliders parties = options.parties;
  parties.subject = chosen(file, parties.subject, recorded.subject, "clip");
  parties.oracle = chosen(file, parties.oracle, recorded.oracle, "box2d");
  const Collider subject = find_subject(parties);
  const Collider oracle = find_oracle(parties);
  Interruption interruption(kUntilSignal);
  const JudgedCase judged = ask_both(given, subject, oracle, interruption);
  if (!options.svg.empty() && options.svg != "-") write_file(options.svg, case_svg(judged));
  std::string text = options.svg == "-" ? case_svg(judged)
                     : options.upstream ? upstream_report(judged, options_again(parties))
                                        : case_text(judged);
  if (options.text_picture && options.svg != "-") text += '\n' + text_picture(judged);
  if (options.map) {
    const std::string words = write_map(options, judged, subject, oracle, interruption);
    if (options.svg != "-") text += words;
  }
  Output out;
  out.write(text);
  out.flush();
  return 0;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  add_case_argument(app, options->given);
  add_collider(app, options->parties.subject,
               "the collider under test; if not given, the one the case names, or clip");
  add_collider(app, options->parties.oracle,
               "the collider it is held against; if not given, the one the case names, or box2d");
  add_external_options(app, options->parties.outside);
  app.add_option("--svg", options->svg, "a picture too; - for the picture alone, on stdout")
      ->type_name("FILE");
  app.add_flag("--upstream", options->upstream,
               "a report for the authors of the collider at fault, with a program that shows it");
  app.add_flag("--text-picture", options->text_picture,
               "a picture of characters too, below the text");
  app.add_option(
         "--map", options->map,
         "the case's neighbours as a PNG: one vertex moved by ulps, what each says, who fails")
      ->type_name("FILE.png");
  add_whole_number(app, "--map-step", options->map_step,
                   "how many ulps apart neighbours are; 1 if not given", 1);
  return [options] { return show(*options); };
}

}  // namespace

extern const Command kShow;
const Command kShow{
    "show", "A case as text and as a picture: polygons, contact points, verdict.",
    "manifuzz generate --seed 1 --regime boxes --cases 1 | manifuzz show - --svg case.svg "
    "--map case.png\n"
    "manifuzz show oracle/known/missed_contact/none/b",
    define};

}  // namespace manifuzz
