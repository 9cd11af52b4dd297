#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/candidates.hpp"

namespace manifuzz::scene {

/// So many rows ahead, the next are asked for: they lie anywhere in memory.
inline constexpr std::uint32_t kRowsAhead = 16;

/// A candidate that waits to be collided.
struct Waiting {
  std::uint32_t a;      ///< the body of lower index
  std::uint32_t place;  ///< among the candidates
};

/// They wait together.
struct Queue {
  std::vector<Waiting> pairs;  ///< and room for more
  std::size_t count = 0;       ///< of those that wait

  /// Whether so many more leave some of it.
  bool has_room(std::size_t more) const { return count + more < pairs.size(); }
};

/// What a step must know of a body besides the length of its path.
enum Mark : std::uint32_t {
  kHasMoved = 1,  ///< it moved, was added or got another shape
  kHasLeft = 2,   ///< it left its fattened box
};

/// Both in one number: the path, a length >= 0, rounded up to where the last two bits are free.
inline std::uint32_t mark_of(float path, std::uint32_t marks) {
  return ((std::bit_cast<std::uint32_t>(path) + 3) & ~std::uint32_t{3}) | marks;
}

/// Where the pairs of rows go, of which a body moved.
struct SortedPairs {
  Queue& touching;            ///< those that touched
  Queue& apart;               ///< those that did not, and are not proven apart
  Queue& leaving;             ///< those of which a body left its fattened box
  bool any_left;              ///< whether any body did
  std::size_t separated = 0;  ///< how many are proven apart
};

/// Sorts row after row, the first one and those behind it, as long as the queues have room for one;
/// the row to go on with. `marks` is by body.
std::uint32_t sort_rows(Candidates& candidates, const std::uint32_t* marks, std::uint32_t first,
                        SortedPairs& sorted);

}  // namespace manifuzz::scene
