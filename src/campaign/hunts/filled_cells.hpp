#pragma once

#include <cstdint>

namespace manifuzz {

/// How many cells a hunt, or as many drawn cases, filled.
struct FilledCells {
  std::uint64_t all = 0;
  std::uint64_t of_pairs = 0;  ///< of pairs of conditions with their bins

  friend bool operator==(const FilledCells&, const FilledCells&) = default;
};

}  // namespace manifuzz
