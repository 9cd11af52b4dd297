#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "corpus/corpus.hpp"

namespace manifuzz {

/// What is known: a corpus folder, sorted by path, and a line for each broken file; empty where
/// there is no such folder. Throws UserError where none is named.
Corpus read_known(const std::filesystem::path& folder);

/// A corpus folder, sorted by path; empty where there is no such folder. Throws UserError on the
/// first broken file, for what is drawn from a corpus depends on all of it.
Corpus read_corpus_folder(const std::filesystem::path& folder);

/// The pairs that a campaign with this seed may mutate: all but those that the seed itself or a
/// property found, so that saving a finding changes no case and its command repeats it.
std::vector<PairCase> pairs_of(const Corpus& corpus, std::uint64_t seed);

}  // namespace manifuzz
