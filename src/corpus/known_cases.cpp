#include "corpus/known_cases.hpp"

#include "base/user_error.hpp"

namespace manifuzz {

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
