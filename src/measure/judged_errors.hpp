#pragma once

#include <array>
#include <optional>
#include <span>

#include "collider/collider.hpp"

namespace manifuzz {

/// Of all cases in which there is a contact; in units of 2^-24 of the extent.
struct ErrorSpread {
  double median = 0;
  double p999 = 0;
  double max = 0;
  std::optional<PairCase> worst;
};

struct JudgedErrors {
  ErrorSpread depth;
  ErrorSpread position;
  ErrorSpread normal;
  std::size_t missed = 0;   ///< no contact where every right manifold has one
  std::size_t phantom = 0;  ///< a contact where none has
  std::size_t cases = 0;
};

/// What the judge finds a collider to be off by.
JudgedErrors judged_errors(const Collider& collider, std::span<const PairCase> pairs);

}  // namespace manifuzz
