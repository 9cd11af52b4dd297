#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/file.hpp"
#include "base/text.hpp"
#include "cli/options.hpp"
#include "cli/sequences.hpp"
#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "sequence/motions.hpp"

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

/// Prints cases of these families by turns, a line each, as `draw` makes them.
template <class Family, class Draw>
void print_cases(const std::vector<const Family*>& families, const GenerateArguments& options,
                 std::uint64_t seed, const Draw& draw) {
  Output out;
  std::string line;
  for (std::uint64_t k = 0; k < *options.cases; ++k) {
    const Family& family = *families[k % families.size()];
    const std::uint64_t index = *options.first + k / families.size();
    line.clear();
    append_found_case_line(line, draw(family, index), {seed, std::string(family.name), index, {}});
    out.write(line += '\n');
  }
  out.flush();
}

void generate_sequences(const GenerateArguments& options) {
  expect_none_of({{"--radius", options.radius.has_value()}});
  expect_motions(options.regimes);
  const auto chosen = chosen_by_name(motions(), options.regimes, "motion", "--regime");
  expect_indices(*options.first, *options.cases, chosen.size());
  const std::uint64_t seed = seed_or_draw(options.seed);
  print_cases(chosen, options, seed, [&](const Motion& motion, std::uint64_t index) {
    return draw_sequence(seed, motion, index);
  });
}

void generate_pairs(const GenerateArguments& options) {
  const auto chosen = chosen_by_name(regimes(), options.regimes, "regime", "--regime");
  expect_indices(*options.first, *options.cases, chosen.size());
  GenerationContext context;
  if (options.radius) context.radius = radius_of(*options.radius);
  const Corpus corpus = read_corpus_folder(options.folders.corpus());
  const std::uint64_t seed = seed_or_draw(options.seed);
  const std::vector<PairCase> pairs = pairs_of(corpus, seed);
  context.corpus = pairs;
  print_cases(chosen, options, seed, [&](const Regime& regime, std::uint64_t index) {
    return generate(seed, regime, index, context);
  });
}

int generate_cases(const GenerateArguments& options) {
  any_motion(options.regimes) ? generate_sequences(options) : generate_pairs(options);
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

const Command kGenerate{
    "generate",
    "Print random cases of the named regimes, or sequences of the named motions, one a line.",
    "manifuzz generate --seed 1 --regime sliver --cases 1000 > slivers.jsonl\n"
    "manifuzz generate --seed 1 --regime turning_platform --cases 10",
    define<GenerateArguments, add_generate_arguments, generate_cases>};

}  // namespace manifuzz
