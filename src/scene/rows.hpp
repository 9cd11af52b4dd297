#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/packed.hpp"
#include "scene/candidates.hpp"
#include "scene/state.hpp"

namespace manifuzz::scene {

/// So many rows ahead, the next are asked for: they lie anywhere in memory.
inline constexpr std::uint32_t kRowsAhead = 16;

/// So many pairs are sorted together. So many behind a queue's room are read by who asks for what
/// pairs need ahead, too.
inline constexpr std::size_t kPairLanes = 16;

/// Candidates that wait to be collided, or of which a body left; an array each for what is known of
/// them, with room for more behind those that wait, and kPairLanes behind that room: these may be
/// written and read, and mean nothing.
struct Queue {
  std::vector<std::uint32_t> a;   ///< the body of lower index
  std::vector<std::uint32_t> b;   ///< the other
  std::vector<std::uint32_t> at;  ///< the contact's index, or the place among the candidates
  std::size_t count = 0;          ///< of those that wait

  kernel::BodyPair bodies(std::size_t i) const { return {a[i], b[i]}; }
  /// How many find room.
  std::size_t room() const { return a.empty() ? 0 : a.size() - kPairLanes; }
  /// At least so much room.
  void make_room_for(std::size_t pairs) {
    if (room() >= pairs) return;
    // `a` last: it says how much room there is, should memory run out before.
    for (auto* const column : {&b, &at, &a}) resize(*column, pairs + kPairLanes);
  }
  /// The next one, if it is chosen; no branch depends on that.
  void push(const kernel::BodyPair& pair, std::uint32_t where, bool chosen = true) {
    a[count] = pair.a;
    b[count] = pair.b;
    at[count] = where;
    count += static_cast<std::size_t>(chosen);
  }
  /// The memory it takes.
  std::size_t bytes() const { return 3 * sizeof(a[0]) * a.capacity(); }
};

/// What a step must know of a body, in one number: its path, a length >= 0, rounded up to where the
/// last two bits are free, and in these whether it moved, and whether it left its fattened box.
inline std::uint32_t mark_of(float path, std::uint8_t state) {
  return ((std::bit_cast<std::uint32_t>(path) + 3) & ~std::uint32_t{3}) |
         (state & (kMoved | kLeft));
}

/// Where the pairs of rows go, of which a body moved.
struct SortedPairs {
  Queue& touching;            ///< those that touched, at their contacts
  Queue& apart;               ///< those that did not, and are not proven apart, at their places
  Queue& leaving;             ///< those of which a body left its fattened box, at their places
  bool any_left;              ///< whether any body did
  std::size_t separated = 0;  ///< how many are proven apart
};

/// Sorts the rows from the first to before the last, as long as the queues have room for one; the
/// row to go on with. `marks` is by body.
std::uint32_t sort_rows(const CandidateRows& rows, const std::uint32_t* marks, std::uint32_t first,
                        std::uint32_t last, SortedPairs& sorted);

}  // namespace manifuzz::scene
