#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/corpus.hpp"
#include "cases/nearest.hpp"
#include "cases/text.hpp"
#include "cases/user_error.hpp"
#include "cli/ci_output.hpp"
#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/parties.hpp"
#include "cli/property_check.hpp"

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
  CiOutput ci;
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

/// What repeats a property beside RC_PARAMS; no absolute path goes into what is kept.
std::string options_again(const Options& options, std::uint64_t seed) {
  std::string text =
      fmt::format("{} --seed {}", options_again(options.subject, options.outside), seed);
  const auto corpus = std::filesystem::proximate(options.corpus).string();
  return corpus == "corpus" ? text : text + " --corpus " + quoted_for_shell(corpus);
}

int run(Options& options) {
  options.ci.stdout_is_data = takes_stdout({{"--junit", options.ci.junit}});
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

  Outputs outputs;
  const std::vector<CheckedProperty> checked = check_properties(
      chosen, subject, plan, options.no_save ? "" : options.corpus,
      [&](const CheckedProperty& one) {
        if (!options.ci.stdout_is_data && !(one.result.passed && is_quiet())) {
          Output out;
          out.write(property_text(one));
          out.flush();
        }
        outputs.write(!one.why_unsaved.empty(), [&] { throw UserError(one.why_unsaved); });
        return true;
      });
  if (is_wanted(options.ci)) {
    Interruption interruption;
    const TestSuite suite =
        property_suite(checked, subject, options_again(options, plan.seed), interruption);
    write_ci(options.ci, {&suite, 1}, outputs);
  }
  if (!outputs.are_written()) return 2;
  return std::ranges::all_of(checked, &CheckedProperty::holds) ? 0 : 1;
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
  add_junit(app, options->ci);
  return [options] { return run_for_ci("property", options->ci, [&] { return run(*options); }); };
}

}  // namespace

extern const Command kProperty;
const Command kProperty{"property", "The properties, which need no oracle, over any collider.",
                        "manifuzz property swapping-mirrors --subject clip --cases 100000 --seed 1",
                        define};

}  // namespace manifuzz
