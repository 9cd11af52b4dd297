#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "conformance/suite.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

struct ConformanceArguments {
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> cases;
  std::string corpus = "corpus";
  std::string output = "-";
};

std::string table_of(const Suite& made) {
  std::string table = "source            taken  left out\n";
  for (const SuiteSource& source : made.sources) {
    table += fmt::format("{:16} {:6} {:9}\n", source.name, source.taken, source.left_out);
  }
  return table;
}

int write_suite(const ConformanceArguments& options) {
  const bool takes_screen = check_outputs({{{"--output", options.output}}});
  SuitePlan plan{.corpus = options.corpus};
  plan.seed = options.seed.value_or(plan.seed);
  plan.cases = options.cases.value_or(plan.cases);
  const ProgressLine line;
  const Suite made = suite(plan, [&](std::size_t done) {
    line.show(fmt::format("{} of {}", done, counted(plan.cases, "case")));
  });
  std::string text;
  for (const std::string& one : made.lines) (text += one) += '\n';
  write_data(options.output, text);
  if (!takes_screen) write_output(table_of(made));
  return 0;
}

void add_conformance_arguments(CLI::App& app, ConformanceArguments& options) {
  constexpr std::uint64_t kCasesMax = 1'000'000;
  add_whole_number(app, "--seed", options.seed, "random seed; default: 1");
  add_whole_number(
      app, "--cases", options.cases,
      "number of cases; the worst ones, the witnesses and the picks come first, however "
      "many they are; default: 2000",
      1, kCasesMax);
  add_text(app, "--corpus", options.corpus, "DIR",
           "folder of the worst cases, the witnesses and the picks; default: corpus");
  add_text(app, "--output", options.output, "FILE", "file for the cases; default: - for stdout");
}

}  // namespace

Run define_conformance(CLI::App& app) {
  return define<ConformanceArguments, add_conformance_arguments, write_suite>(app);
}

}  // namespace manifuzz
