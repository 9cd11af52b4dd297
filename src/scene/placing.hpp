#pragma once

#include <cstdint>
#include <span>

#include "afresh/shape_table.hpp"
#include "kernel/packed.hpp"
#include "scene/body.hpp"
#include "scene/state.hpp"

namespace manifuzz::scene {

/// A body that may have left its fattened box, and where it was before the move that made it so.
struct Mover {
  std::uint32_t body;   ///< its place
  Vector2<float> from;  ///< in the world
};

/// What is written where bodies are put: arrays by body, and two lists, each with room for as many
/// as there are moves.
struct Placing {
  const ShapeFacts* facts;               ///< by shape
  kernel::Placement<float>* placements;  ///< in the world
  std::uint8_t* states;                  ///< of `State`
  float* paths;                          ///< how far its vertices went, at most; lengths
  const float* leave_at;                 ///< it is in its fattened box until its path is longer
  std::uint32_t* moved;                  ///< bodies that had not moved in this step
  Mover* unsure;  ///< those that may have left their fattened boxes from now on
};

/// How many were added to the lists.
struct PlacedCounts {
  std::size_t moved = 0;   ///< bodies that moved
  std::size_t unsure = 0;  ///< bodies that may have left their fattened boxes
};

/// Whether no move has a defect, and each names a body that is there: its generation, given by
/// place, is odd.
bool are_sound(std::span<const Move> moves, std::span<const std::uint32_t> generations);

/// Whether each move is of a body of higher index than the one before.
bool do_ascend(std::span<const Move> moves);

/// Puts bodies, which must be there, where they are now, move by move.
PlacedCounts place_moves(std::span<const Move> moves, const Placing& placing);

}  // namespace manifuzz::scene
