#include "measure/digest.hpp"

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "cli/colliders.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "measure/provenance.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kCasesMax = 1'000'000'000;

struct DigestArguments {
  ColliderChoice collider{"collider", "clip", ""};
  ExternalOptions external;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> cases;
  std::string json;
};

std::string digits_of(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

std::string digest_table(const DigestPlan& plan, const Digest& digest) {
  const Declaration& declaration = plan.collider.declaration;
  constexpr const char* kRow = "{:<18}{:>12}{:>12}{:>20}\n";
  std::string text = fmt::format("{} {}: every bit of its answers, seed {}\n\n", declaration.name,
                                 declaration.version, plan.seed) +
                     fmt::format(fmt::runtime(kRow), "regime", "cases", "contacts", "digest");
  for (const RegimeDigest& regime : digest.regimes) {
    text += fmt::format(fmt::runtime(kRow), regime.regime, plan.cases, regime.contacts,
                        digits_of(regime.hash));
  }
  return text + fmt::format(fmt::runtime(kRow), "all", digest.regimes.size() * plan.cases, "",
                            digits_of(digest.hash));
}

nlohmann::ordered_json digest_json(const DigestPlan& plan, const Digest& digest) {
  nlohmann::ordered_json json = provenance(plan.seed, {plan.collider.declaration});
  json["collider"] = plan.collider.declaration.name;
  json["cases"] = digest.regimes.size() * plan.cases;
  json["digest"] = digits_of(digest.hash);
  json["regimes"] = nlohmann::ordered_json::array();
  for (const RegimeDigest& regime : digest.regimes) {
    json["regimes"].push_back({{"name", regime.regime},
                               {"cases", plan.cases},
                               {"contacts", regime.contacts},
                               {"digest", digits_of(regime.hash)}});
  }
  return json;
}

Digest run(const DigestPlan& plan) {
  Interruption interruption(kUntilSignal);
  const ProgressLine line;
  const std::uint64_t all = regimes().size() * plan.cases;
  return digest(plan, interruption, [&](std::uint64_t done) {
    line.show(fmt::format("{}% of {} cases", 100 * done / all, all));
  });
}

int digest_command(const DigestArguments& options) {
  check_outputs({{{"--json", options.json}}});
  DigestPlan plan{.collider = find_collider(options.collider, options.external)};
  plan.seed = options.seed.value_or(plan.seed);
  plan.cases = options.cases.value_or(plan.cases);
  const Digest result = run(plan);
  const std::string json = json_text(digest_json(plan, result));
  Outputs outputs;
  outputs.write(true, [&] {
    write_to_reader(options.json == "-"                 ? json
                    : leaves_out_tables({options.json}) ? ""
                                                        : digest_table(plan, result));
  });
  outputs.write(!options.json.empty() && options.json != "-",
                [&] { write_file(options.json, json); });
  return outputs.are_written() ? 0 : 2;
}

void add_digest_arguments(CLI::App& app, DigestArguments& options) {
  add_collider(app, options.collider, "whose answers; clip if not given");
  add_external_options(app, options.external);
  add_whole_number(app, "--seed", options.seed, "what the cases depend on; 1 if not given");
  add_whole_number(app, "--cases", options.cases, "of each regime; 10000 if not given", 1,
                   kCasesMax);
  add_json(app, options.json, "the hashes as JSON");
}

}  // namespace

const Command kDigest{"digest", "One hash a regime of every bit of a collider's answers.",
                      "manifuzz digest --collider batch --cases 1000",
                      define<DigestArguments, add_digest_arguments, digest_command>};

}  // namespace manifuzz
