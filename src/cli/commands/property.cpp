#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/campaign_options.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "hunting/property_hunt.hpp"
#include "report/ci/ci_output.hpp"
#include "report/measurements/property_hunt_text.hpp"
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
  bool is_hunt = false;
  std::optional<std::uint64_t> jobs;
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

/// What checks the properties, by drawing or by hunting.
struct PropertySession {
  const PropertyArguments& options;
  std::vector<const Property*> chosen;
  Collider subject;
  std::uint64_t seed = 0;
  std::vector<PairCase> corpus;
  Known known;
  std::function<void(const CheckedProperty&)> tell;
};

std::string rc_params() {
  const char* const value = std::getenv("RC_PARAMS");
  return value == nullptr ? "" : value;
}

std::vector<CheckedProperty> check_drawn(const PropertySession& session) {
  PropertyPlan plan;
  plan.cases = static_cast<int>(session.options.cases.value_or(kDefaultCases));
  plan.seed = session.seed;
  plan.rc_params = rc_params();
  plan.corpus = session.corpus;
  return check_properties(session.chosen, session.subject, plan, session.known, {},
                          session.options.folders.save_to(), session.tell);
}

std::vector<CheckedProperty> check_hunted(const PropertySession& session, const ProgressLine& line,
                                          std::string& row) {
  const PropertyArguments& options = session.options;
  const PropertyHuntPlan plan{.properties = session.chosen,
                              .subject = session.subject,
                              .corpus = session.corpus,
                              .seed = session.seed,
                              .cases = options.cases.value_or(kDefaultCases),
                              .jobs = jobs_of(options.jobs),
                              .save_to = options.folders.save_to()};
  Interruption interruption;  // until it is saved: a signal between the steps ends no step
  const PropertyHunt hunt = hunt_properties(
      plan, interruption,
      [&](const PropertyHuntProgress& progress) { line.show(property_hunt_line(progress)); });
  row = property_hunt_row(hunt);
  return checked_by_hunt(hunt, plan, session.known, interruption, session.tell);
}

int hold_properties(PropertyArguments& options) {
  check_outputs({{options.folders.saved()}, options.folders.all()}, options.ci);
  if (options.is_hunt && !rc_params().empty()) {
    throw UserError(
        "RC_PARAMS: repeats a drawn case, which --hunt does not; unset it, or leave out --hunt");
  }
  const std::vector<const Property*> chosen =
      chosen_by_name(properties(), options.names, "property", "property");
  const Collider subject = find_collider(options.subject, options.external);
  const Corpus corpus = read_corpus_folder(options.folders.corpus());
  const Known known = known_of(read_whole(options.folders).cases, options.today);
  const std::uint64_t seed = seed_or_draw(options.seed);

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
  const PropertySession session{options, chosen, subject, seed, pairs_of(corpus, seed),
                                known,   tell};
  std::string of_hunt;
  const std::vector<CheckedProperty> checked =
      options.is_hunt ? check_hunted(session, line, of_hunt) : check_drawn(session);
  if (all.is_stopped()) outputs.add_interruption("property: interrupted before it was done");
  line.show("");
  const CalledAgain again{this_program(), options_again(options, seed),
                          options_to_show({options.subject, {}, options.external})};
  outputs.write(!is_quiet() && !options.ci.stdout_is_data, [&] {
    const std::string screen =
        options.is_verbose ? "" : property_screen(checked, subject.declaration.name, again);
    write_to_reader(screen + of_hunt);
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
  CLI::Option* const hunt = app.add_flag(
      "--hunt", options.is_hunt,
      "breed cases as the command hunt does, from those on which a property fails by most or takes "
      "most of its bound, and ask all properties of each; --cases counts them once");
  add_jobs(app, options.jobs)->needs(hunt);
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
