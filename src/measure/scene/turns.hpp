#pragma once

#include <cstddef>

namespace manifuzz {

/// Whose turn it is in a step, since whoever steps finds the caches as the one before has left
/// them. Two keep their order: if it changed, each would follow itself now and then. Where there
/// are more, each has each turn once in as many steps as they are and, within steps, follows each
/// other once; where they are odd, each other twice in twice as many (E. J. Williams, Australian
/// Journal of Scientific Research, 1949).
inline std::size_t whose_turn(std::size_t step, std::size_t turn, std::size_t count) {
  if (count == 2) return turn;
  const bool is_reversed = count % 2 == 1 && step / count % 2 == 1;
  const std::size_t at = is_reversed ? count - 1 - turn : turn;
  const std::size_t beside = at % 2 == 1 ? at / 2 + 1 : count - at / 2;
  return (step + beside) % count;
}

}  // namespace manifuzz
