#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "generating/regime.hpp"

namespace manifuzz {
namespace {

struct GenerateArguments {
  std::optional<std::uint64_t> seed;
  std::vector<std::string> regimes;
  std::optional<std::uint64_t> first = 0;
  std::optional<std::uint64_t> cases = 10;
  std::optional<double> radius;
  CorpusFolders folders;
};

int generate_cases(const GenerateArguments& options) {
  const DrawOptions draw{options.regimes, options.seed, *options.first, *options.cases};
  if (const OtherKind* const kind = kind_for(options.regimes)) {
    expect_none_of(*kind, {{"--radius", options.radius.has_value()},
                           {"--corpus", options.folders.named.has_value()}});
    expect_regimes_of(*kind, options.regimes);
    return kind->generate(draw);
  }
  const auto chosen = chosen_by_name(regimes(), options.regimes, "regime", "--regime");
  expect_indices(draw.first, draw.count, chosen.size());
  GenerationContext context;
  if (options.radius) context.radius = radius_of(*options.radius);
  const Corpus corpus = read_corpus_folder(options.folders.corpus());
  const std::uint64_t seed = seed_or_draw(options.seed);
  const std::vector<PairCase> pairs = pairs_of(corpus, seed);
  context.corpus = pairs;
  print_drawn(chosen, draw, seed, [&](const Regime& regime, std::uint64_t index) {
    return generate(seed, regime, index, context);
  });
  return 0;
}

void add_generate_arguments(CLI::App& app, GenerateArguments& options) {
  add_seed(app, options.seed);
  add_regimes(app, options.regimes);
  add_whole_number(app, "--first", options.first,
                   "index of the first case in each regime; default: 0");
  add_whole_number(app, "--cases", options.cases, "number of cases; default: 10", 1);
  add_radius(app, options.radius);
  add_corpus(app, options.folders,
             "folder of the cases that the regime corpus mutates; default: corpus");
}

}  // namespace

Run define_generate(CLI::App& app) {
  return define<GenerateArguments, add_generate_arguments, generate_cases>(app);
}

}  // namespace manifuzz
