#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "campaign/guarded.hpp"
#include "cases/file.hpp"
#include "cli/colliders.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "report/case_picture.hpp"
#include "report/case_text.hpp"

namespace manifuzz {
namespace {

struct Options {
  std::string file;
  std::string subject;
  std::string oracle;
  std::string svg;
};

/// What was asked for, else what the case names, else the usual one.
std::string chosen(const std::string& asked, const std::string& recorded, const char* usual) {
  if (!asked.empty()) return asked;
  return recorded.empty() ? usual : recorded;
}

/// Asks in a child process first, so that a collider that dies or hangs takes nothing along.
Party ask(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  const std::atomic<int> pulse{0};
  switch (run_guarded([&] { collider.collide(pair); }, pulse, interruption)) {
    case Ending::well:
      return {collider.declaration, collider.collide(pair), {}};
    case Ending::crashed:
      return {collider.declaration, std::nullopt, "crashed"};
    case Ending::hung:
      return {collider.declaration, std::nullopt, "timed out"};
    default:
      return {collider.declaration, std::nullopt, "interrupted"};
  }
}

int show(const Options& options) {
  const CorpusCase given = read_case_file(options.file);
  const Expectation recorded = given.expect.value_or(Expectation{});
  const Collider subject = find_collider(chosen(options.subject, recorded.subject, "clip"));
  const Collider oracle = find_collider(chosen(options.oracle, recorded.oracle, "box2d"));
  Interruption interruption;
  const ShownCase shown{given, ask(subject, given.pair, interruption),
                        ask(oracle, given.pair, interruption),
                        judge_guarded(given.pair, subject, oracle, interruption)};
  if (!options.svg.empty() && options.svg != "-") write_file(options.svg, case_svg(shown));
  Output out;
  out.write(options.svg == "-" ? case_svg(shown) : case_text(shown));
  out.flush();
  return 0;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "a case, - for stdin")->type_name("FILE")->required();
  app.add_option("--subject", options->subject,
                 "the collider under test; if not given, the one the case names, or clip")
      ->type_name("C");
  app.add_option("--oracle", options->oracle,
                 "the collider it is held against; if not given, the one the case names, or box2d")
      ->type_name("C");
  app.add_option("--svg", options->svg, "a picture too; - for the picture alone, on stdout")
      ->type_name("FILE");
  return [options] { return show(*options); };
}

}  // namespace

extern const Command kShow;
const Command kShow{"show", "A case as text and as a picture: polygons, contact points, verdict.",
                    "manifuzz generate --seed 1 --regime boxes --cases 1 | manifuzz show - --svg "
                    "case.svg",
                    define};

}  // namespace manifuzz
