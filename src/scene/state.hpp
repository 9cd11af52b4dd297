#pragma once

#include <cstdint>

namespace manifuzz::scene {

/// What happened to a body since the last step, and what is known of it: flags of a byte.
enum State : std::uint8_t {
  kMoved = 1,          ///< it moved, was added or got another shape
  kLeft = 2,           ///< it left its fattened box
  kUnproven = 4,       ///< its path began anew: no proof holds
  kFiled = 8,          ///< it is in the cells
  kAlone = 16,         ///< it had no partners when its box was drawn
  kBoxed = 32,         ///< its tight box is where it is
  kUnsure = 64,        ///< it moved, and may have left its fattened box
  kFewPartners = 128,  ///< it had one partner or two when its box was drawn
};

}  // namespace manifuzz::scene
