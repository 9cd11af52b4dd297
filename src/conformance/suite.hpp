#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// What a conformance suite is made of.
struct SuitePlan {
  std::filesystem::path corpus = "corpus";  ///< its worst cases, witnesses and picks are taken
  std::uint64_t seed = 1;                   ///< of the cases that fill it up
  std::size_t cases = 2000;
};

/// Where cases come from.
struct SuiteSource {
  std::string name;
  std::size_t taken = 0;
  std::size_t left_out = 0;  ///< looked at, but the suite cannot say what is right there
};

struct Suite {
  std::vector<std::string> lines;
  std::vector<SuiteSource> sources;
};

/// The suite of that plan: the worst known cases, the witness of each cause of the ledger, the
/// regimes, as many of each, those first that look like none before, and the picks
/// (conformance/picks.txt of the corpus). Each pair is there once. `progress` gets the number of
/// lines so far. Throws UserError.
Suite suite(const SuitePlan& plan, const std::function<void(std::size_t)>& progress);

/// The pair of that name: `REGIME/SEED/INDEX`, `worst/COLLIDER/MEASURE` or `ledger/CAUSE`; none
/// where the name is no such. Throws UserError where the corpus's file is broken or not there.
std::optional<PairCase> named_pair(std::string_view name, const std::filesystem::path& corpus);

}  // namespace manifuzz
