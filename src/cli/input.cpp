#include "cli/input.hpp"

#include <limits>

#include "base/names.hpp"
#include "base/user_error.hpp"

namespace manifuzz {

std::vector<const Regime*> choose_regimes(const std::vector<std::string>& names) {
  return chosen_by_name(regimes(), names, "regime", "--regime");
}

void expect_indices(std::uint64_t first, std::uint64_t cases, std::size_t regimes) {
  if ((cases - 1) / regimes <= std::numeric_limits<std::uint64_t>::max() - first) return;
  throw UserError("--first: the last index passes 18446744073709551615; take fewer --cases");
}

Corpus read_known(const std::filesystem::path& folder) {
  if (folder.empty()) throw UserError("--corpus: is empty; a folder is expected");
  std::error_code unreadable;
  if (!std::filesystem::exists(folder, unreadable) && !unreadable) return {};
  return read_corpus({&folder, 1});
}

Corpus read_corpus_folder(const std::filesystem::path& folder) {
  Corpus corpus = read_known(folder);
  if (!corpus.errors.empty()) throw UserError(corpus.errors.front());
  return corpus;
}

std::vector<PairCase> pairs_of(const Corpus& corpus, std::uint64_t seed) {
  std::vector<PairCase> pairs;
  for (const CorpusCase& known : corpus.cases) {
    const bool found_here = known.found && known.found->seed == seed;
    if (!found_here && known.property.empty()) pairs.push_back(known.pair);
  }
  return pairs;
}

}  // namespace manifuzz
