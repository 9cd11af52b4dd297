#pragma once

#include <optional>
#include <utility>

#include <rapidcheck.h>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// The cases that `make(0)`, ..., `make(count - 1)` give, made when they are asked for.
template <class Make>
rc::Seq<PairCase> each_case(int count, Make make) {
  return rc::seq::mapMaybe(rc::seq::range(0, count), [make](int i) -> rc::Maybe<PairCase> {
    if (std::optional<PairCase> made = make(i)) return std::move(*made);
    return rc::Nothing;
  });
}

// Changes after which a case is easier to believe. Not all that they give is valid or simpler.

/// Numbers that are no ordinary ones brought to ordinary sizes with their digits: all numbers,
/// their decimal places divided so that their order stays, then the odd ones alone, then one at a
/// time.
rc::Seq<PairCase> with_ordinary_numbers(const PairCase& pair);

/// Where faces nearly tie, one number changed so much that they may not: by a round share of it, or
/// by a round length.
rc::Seq<PairCase> with_a_clearer_lead(const PairCase& pair);

}  // namespace manifuzz
