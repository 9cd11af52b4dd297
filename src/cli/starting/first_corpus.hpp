#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "collider/collider.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// What a first corpus is made of.
struct FirstCorpusPlan {
  Collider subject;
  Collider oracle;
  std::uint64_t cases = 0;  ///< of the campaign
};

struct FirstCorpus {
  std::size_t seeds = 0;             ///< cases of the regimes, at which the subject is right
  std::size_t accepted = 0;          ///< findings of which it is guilty
  std::string verdicts{};            ///< how wrong it was, in words
  std::vector<std::string> hints{};  ///< mistakes of its adapter that make its wrong answers
};

/// Runs a campaign and the properties with seed 1, saves in the folder what they find and a few
/// cases of each regime, and accepts the kinds of what the subject is guilty of, however bad: a
/// later run then fails for another kind, or for more of them. Throws UserError where a file cannot
/// be written, where the subject gives no answers, and where a signal stops it.
FirstCorpus write_first_corpus(const std::filesystem::path& folder, const FirstCorpusPlan& plan,
                               Interruption& all);

}  // namespace manifuzz
