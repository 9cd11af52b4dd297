#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "campaign/property_run.hpp"
#include "cases/corpus.hpp"
#include "cases/nearest.hpp"
#include "cases/user_error.hpp"
#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/parties.hpp"
#include "report/style.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kDefaultCases = 10'000;
constexpr std::uint64_t kCasesMax = 1'000'000'000;

struct Options {
  std::vector<std::string> names;
  ColliderChoice subject{"subject", "clip", ""};
  OutsideOptions outside;
  std::optional<std::uint64_t> cases;
  std::optional<std::uint64_t> seed;
  std::string corpus = "corpus";
  bool no_save = false;
};

std::vector<const Property*> choose(const std::vector<std::string>& names) {
  std::vector<const Property*> chosen;
  std::vector<std::string_view> known;
  for (const Property& property : properties()) {
    known.push_back(property.name);
    if (names.empty()) chosen.push_back(&property);
  }
  for (const std::string& name : names) {
    chosen.push_back(find_property(name));
    if (chosen.back() == nullptr) {
      throw UserError("property: " + no_such("property", name, known));
    }
  }
  return chosen;
}

/// Writes the failing case to the corpus and returns its path.
std::string save(const Options& options, const Property& property, const Collider& subject,
                 const PropertyResult& result) {
  CorpusCase failing;
  failing.pair = *result.failing;
  failing.property = std::string(property.name);
  failing.note = fmt::format("{} {}: {}: {}.", subject.declaration.name,
                             subject.declaration.version, property.sentence, result.why);
  const auto folder = std::filesystem::path(options.corpus) / "regressions";
  return write_corpus_case(folder, failing).string();
}

int run(const Options& options) {
  const std::vector<const Property*> chosen = choose(options.names);
  const Collider subject = find_collider(options.subject, options.outside);
  const std::uint64_t cases = options.cases.value_or(kDefaultCases);
  if (cases > kCasesMax) {
    throw UserError(fmt::format("--cases: {} are too many; take 1 to {}", cases, kCasesMax));
  }
  const Corpus corpus = read_corpus_folder(options.corpus);
  PropertyPlan plan;
  plan.seed = seed_or_draw(options.seed);
  plan.cases = static_cast<int>(cases);
  const std::vector<PairCase> pairs = pairs_of(corpus, plan.seed);
  plan.corpus = pairs;
  if (const char* const rc_params = std::getenv("RC_PARAMS")) plan.rc_params = rc_params;

  Output out;
  bool all_passed = true;
  for (const Property* property : chosen) {
    const PropertyResult result = run_property(*property, subject, plan);
    if (result.passed && is_quiet()) continue;
    out.write(fmt::format("{} {}: {}\n{}\n", result.passed ? good("ok  ") : bad("FAIL"),
                          property->name, property->sentence, result.report));
    if (!result.passed && result.failing) {
      out.write(fmt::format("repeat with RC_PARAMS=\"{}\"\n", result.reproduce));
      if (!options.no_save) {
        out.write(fmt::format("saved {}\n", save(options, *property, subject, result)));
      }
    }
    out.flush();
    all_passed = all_passed && result.passed;
  }
  return all_passed ? 0 : 1;
}

Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("names", options->names, "which; all if not given")->type_name("NAME");
  add_collider(app, options->subject, "the collider under test");
  add_outside(app, options->outside);
  add_whole_number(app, "--cases", options->cases, "how many for each; 10000 if not given", 1);
  add_whole_number(app, "--seed", options->seed,
                   "what the cases hang on; drawn and printed if not given");
  app.add_option("--corpus", options->corpus, "the folder of known cases, where failures are saved")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_flag("--no-save", options->no_save, "save nothing");
  return [options] { return run(*options); };
}

}  // namespace

extern const Command kProperty;
const Command kProperty{"property", "The properties, which need no oracle, over any collider.",
                        "manifuzz property swapping-mirrors --subject clip --cases 100000 --seed 1",
                        define};

}  // namespace manifuzz
