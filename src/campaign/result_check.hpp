#pragma once

#include "base/json.hpp"
#include "campaign/result.hpp"

namespace manifuzz {

/// A result of `fuzz` tells the same more than once: by sums, regimes, buckets, parts and names.
/// Throws UserError that begins with a path where these contradict each other; `root` is what
/// `result` was read from.
void expect_consistent(const JsonView& root, const FuzzResult& result);

}  // namespace manifuzz
