#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "report/ci/ci_output.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kDefaultCases = 10'000;
constexpr std::uint64_t kPropertyCasesMax =
    100'000'000;  // RapidCheck takes 24 bytes for each at once

struct PropertyArguments {
  std::vector<std::string> names;
  ColliderChoice subject{"subject", "clip", ""};
  ExternalOptions external;
  std::optional<std::uint64_t> cases;
  std::optional<std::uint64_t> seed;
  CorpusFolders folders;
  bool is_verbose = false;
  std::string today;
  CiOutput ci;
};

/// What repeats a property beside RC_PARAMS.
std::string options_again(const PropertyArguments& options, std::uint64_t seed) {
  return fmt::format("{} --seed {}{}", options_again(options.subject, options.external), seed,
                     options.folders.again());
}

PropertyPlan plan_of(const PropertyArguments& options) {
  PropertyPlan plan;
  plan.cases = static_cast<int>(options.cases.value_or(kDefaultCases));
  plan.seed = seed_or_draw(options.seed);
  if (const char* const rc_params = std::getenv("RC_PARAMS")) plan.rc_params = rc_params;
  return plan;
}

int hold_properties(PropertyArguments& options) {
  check_outputs({{options.folders.saved()}, options.folders.all()}, options.ci);
  const std::vector<const Property*> chosen =
      chosen_by_name(properties(), options.names, "property", "property");
  const Collider subject = find_collider(options.subject, options.external);
  const Corpus corpus = read_corpus_folder(options.folders.corpus());
  const Known known = known_of(read_whole(options.folders).cases, options.today);
  PropertyPlan plan = plan_of(options);
  const std::vector<PairCase> pairs = pairs_of(corpus, plan.seed);
  plan.corpus = pairs;

  Interruption all(kUntilSignal);
  Outputs outputs;
  const ProgressLine line;
  std::size_t done = 0;
  const auto tell = [&](const CheckedProperty& one) {
    const bool is_told = options.is_verbose || (is_quiet() && !one.holds());
    outputs.write(is_told && !options.ci.stdout_is_data,
                  [&] { write_to_reader(property_text(one)); });
    outputs.add_error(one.why_unsaved);
    line.show(
        fmt::format("{} of {} tested", ++done, counted(chosen.size(), "property", "properties")));
  };
  const std::vector<CheckedProperty> checked =
      check_properties(chosen, subject, plan, known, {}, options.folders.save_to(), tell);
  if (all.is_stopped()) outputs.add_interruption("property: interrupted before it was done");
  line.show("");
  const CalledAgain again{this_program(), options_again(options, plan.seed),
                          options_to_show({options.subject, {}, options.external})};
  outputs.write(!options.is_verbose && !is_quiet() && !options.ci.stdout_is_data, [&] {
    write_to_reader(property_screen(checked, subject.declaration.name, again));
  });
  if (is_wanted(options.ci)) {
    write_ci(options.ci, {property_suite(checked, subject, again, all)}, outputs);
  }
  if (!outputs.are_written()) return 2;
  return std::ranges::all_of(checked, &CheckedProperty::holds) ? 0 : 1;
}

void add_property_arguments(CLI::App& app, PropertyArguments& options) {
  app.add_option("names", options.names, "properties to test; default: all")->type_name("NAME");
  add_collider(app, options.subject, "collider under test");
  add_external_options(app, options.external);
  add_whole_number(app, "--cases", options.cases,
                   "number of cases for each property; default: 10000", 1, kPropertyCasesMax);
  add_seed(app, options.seed);
  add_corpus(app, options.folders,
             "folder of known cases, in which failures are saved; default: read corpus, and save "
             "failures in build/found of the source tree, or in found outside of it");
  app.add_flag("--no-save", options.folders.is_unsaved, "do not save failures");
  app.add_flag("--verbose", options.is_verbose,
               "print RapidCheck's output for each property in place of the short summary");
  add_today(app, options.today);
  add_junit(app, options.ci.junit);
}

}  // namespace

Run define_property(CLI::App& app) {
  return define<PropertyArguments, add_property_arguments, hold_properties>(app);
}

}  // namespace manifuzz
