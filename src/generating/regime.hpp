#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/random.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// What a regime may draw from besides its random numbers.
struct GenerationContext {
  std::span<const PairCase> corpus;  ///< sorted, read once at start; empty is allowed
  std::optional<float> radius;       ///< of each polygon, in place of the regime's own
};

/// A named family of cases. Adding one changes no case of another.
struct Regime {
  std::string_view name;
  std::string_view description;  ///< one line for `list regimes`
  /// One attempt: none where rounding to floats spoilt a polygon. `generate` below makes cases of
  /// it.
  std::optional<PairCase> (*attempt)(Random& random, const GenerationContext& context);
};

/// Every regime, in the order of `list regimes`.
std::span<const Regime> regimes();

/// The regime of that name, or nullptr.
const Regime* find_regime(std::string_view name);

/// Case `index` of a regime: a function of (seed, the regime's name, index) and, for the regimes
/// that say so, of the corpus.
PairCase generate(std::uint64_t seed, const Regime& regime, std::uint64_t index,
                  const GenerationContext& context = {});

}  // namespace manifuzz
