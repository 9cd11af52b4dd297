#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/plan.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/pictures.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

/// Farther than this the map would be wider than any polygon.
constexpr std::uint64_t kMapStepMax = 100'000;

struct ShowArguments {
  CaseArgument given;
  SubjectAndOracle colliders{{"subject", "", ""}, {"oracle", "", ""}, {}};
  std::string subjects;
  std::string svg;
  std::string curve;
  bool upstream = false;
  bool text_picture = false;
  std::optional<std::string> map;
  std::optional<std::uint64_t> map_step;
};

/// The collider that was asked for, else the one that the case names, built in or in subjects.json,
/// else the usual one; `asked` is how it is asked for then.
Collider chosen(const std::string& file, ColliderChoice& asked, const ExternalOptions& external,
                const std::string& recorded, std::string_view usual) {
  if (asked.is_given()) return find_collider(asked, external);
  asked.name = recorded.empty() ? std::string(usual) : recorded;
  if (const auto named = named_choice(asked, external.named)) {
    return find_named(asked = *named, recorded, external);
  }
  if (find_entry(asked.name) != nullptr) return find_collider(asked, external);
  throw UserError(fmt::format(
      "{}: was found with '{}', which is not built in; say how to start it: --{} ./LIBRARY.so, "
      "--{}-command PROGRAM, --subjects FILE, or a file subjects.json beside the --corpus",
      file, printable(asked.name), asked.role, asked.role));
}

int show(ShowArguments& options) {
  if (options.map_step && !options.map) {
    throw UserError("--map-step: needs --map FILE.png");
  }
  const std::string file = case_file(options.given);
  const CorpusCase given = read_case_file(file, kind_to_read(options.colliders.subject));
  check_outputs({{{"--svg", options.svg, OutputPath::Kind::data, kPictureEndings},
                  {"--curve", options.curve, OutputPath::Kind::file, {".svg", ".png"}},
                  {"--map", options.map.value_or(""), OutputPath::Kind::file, {".png"}}},
                 {file}});
  SubjectAndOracle& asked = options.colliders;
  asked.external.named = read_subjects({options.subjects, options.given.folders.all()});
  if (const OtherKind* const kind = kind_for(given.any)) {
    expect_none_of(*kind, {{"--oracle", !asked.oracle.name.empty()},
                           {"--oracle-command", !asked.oracle.command.empty()},
                           {"--curve", !options.curve.empty()},
                           {"--map", options.map.has_value()},
                           {"--upstream", options.upstream},
                           {"--text-picture", options.text_picture}});
    return kind->show(given, asked.subject, asked.external, options.svg);
  }
  const Expectation recorded = given.expect.value_or(Expectation{});
  const Collider subject = chosen(file, asked.subject, asked.external, recorded.subject, "clip");
  const Collider oracle =
      chosen(file, asked.oracle, asked.external, recorded.oracle, usual_oracle_name());
  Interruption interruption(kUntilSignal);
  const JudgedCase judged = judged_case(given, subject, oracle, interruption);
  const bool is_picture_alone = options.svg == "-";
  if (!options.svg.empty() && !is_picture_alone) {
    const bool is_png = options.svg.ends_with(".png");
    write_file(options.svg, is_png ? png_of(case_svg(judged)) : case_svg(judged));
  }
  if (!options.curve.empty()) {
    const bool is_png = options.curve.ends_with(".png");
    write_file(options.curve, is_png ? curve_png(judged) : curve_svg(judged));
  }
  std::string text = is_picture_alone   ? case_svg(judged)
                     : options.upstream ? upstream_report(judged, options_again(asked))
                                        : case_text(judged);
  if (options.text_picture && !is_picture_alone) text += '\n' + text_picture(judged);
  if (options.map) {
    const auto step_ulps = static_cast<int>(options.map_step.value_or(1));
    const CaseMap map = case_map(judged, subject, oracle, step_ulps, interruption);
    write_file(*options.map, map.png);
    if (!is_picture_alone) text += fmt::format("map: {}\n", fmt::join(map.words, "\n  "));
  }
  write_output(text);
  return 0;
}

void add_show_arguments(CLI::App& app, ShowArguments& options) {
  add_case_argument(app, options.given);
  add_collider(app, options.colliders.subject,
               "collider under test; default: the one that the case names, or clip");
  add_collider(
      app, options.colliders.oracle,
      fmt::format(
          "collider to compare the subject with; default: the one that the case names, or {}",
          usual_oracle_name()));
  add_sequences(app, options.colliders.subject);
  add_external_options(app, options.colliders.external);
  add_subjects(app, options.subjects);
  app.add_option("--svg", options.svg,
                 "draw the case, or a sequence's frames; - prints only the picture, on stdout")
      ->type_name("FILE.svg|FILE.png");
  add_text(app, "--curve", options.curve, "FILE.svg|FILE.png",
           "draw how deep the shapes overlap in each direction, and where each answer lies");
  app.add_flag("--upstream", options.upstream,
               "print a report for the authors of the collider at fault, with a program that shows "
               "the fault");
  app.add_flag("--text-picture", options.text_picture,
               "print the case drawn in text, too, below its description");
  app.add_option(
         "--map", options.map,
         "draw the case's neighbours, with one vertex moved by ulps: which collider fails where")
      ->type_name("FILE.png");
  add_whole_number(app, "--map-step", options.map_step,
                   "distance between neighbours on the map, in ulps; default: 1", 1, kMapStepMax);
}

}  // namespace

Run define_show(CLI::App& app) {
  return define<ShowArguments, add_show_arguments, show>(app);
}

}  // namespace manifuzz
