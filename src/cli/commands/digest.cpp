#include "measure/digest.hpp"

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "report/measurements/measurements.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kDigestCasesMax = 1'000'000'000;

struct DigestArguments {
  ColliderChoice collider{"collider", "clip", ""};
  ExternalOptions external;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> cases;
  std::string json;
};

Digest run(const DigestPlan& plan) {
  Interruption interruption(kUntilSignal);
  const ProgressLine line;
  const std::uint64_t all = regimes().size() * plan.cases;
  return digest(plan, interruption, [&](std::uint64_t done) {
    line.show(fmt::format("{}% of {}", 100 * done / all, counted(all, "case")));
  });
}

int digest_command(const DigestArguments& options) {
  check_outputs({{{"--json", options.json}}});
  DigestPlan plan{.collider = find_collider(options.collider, options.external)};
  plan.seed = options.seed.value_or(plan.seed);
  plan.cases = options.cases.value_or(plan.cases);
  const Digest result = run(plan);
  Outputs outputs;
  write_table(outputs, leaves_out_tables(options.json) ? "" : digest_table(plan, result),
              options.json, json_text(digest_json(plan, result)));
  return outputs.are_written() ? 0 : 2;
}

void add_digest_arguments(CLI::App& app, DigestArguments& options) {
  add_collider(app, options.collider, "collider whose answers are hashed");
  add_external_options(app, options.external);
  add_whole_number(app, "--seed", options.seed, "random seed; default: 1");
  add_whole_number(app, "--cases", options.cases, "number of cases of each regime; default: 10000",
                   1, kDigestCasesMax);
  add_json(app, options.json, "the hashes");
}

}  // namespace

Run define_digest(CLI::App& app) {
  return define<DigestArguments, add_digest_arguments, digest_command>(app);
}

}  // namespace manifuzz
