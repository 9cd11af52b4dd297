#pragma once

#include <string>
#include <string_view>

#include "collider/sequence_collider.hpp"

namespace manifuzz {

class JsonView;

/// "a", "b" or "world".
std::string_view name_of(TravelsWith carrier);

/// A frame of a sequence, for whoever writes lines: which line's sequence, counted from 0, and
/// which frame.
struct FrameNumber {
  std::size_t sequence = 0;
  std::size_t frame = 0;
};

/// Appends what a collider that keeps points answers to a frame, as one line without its end:
/// {"collider": "cached", "sequence": 0, "frame": 3, "points": [{"id": 1, "born": 2, "position":
/// [x, y], "depth": d, "normal": [x, y], "anchor_a": [x, y], "anchor_b": [x, y], "travels_with":
/// "a"}]}. The position, in the world, is that of the anchor on A. Throws UserError where there is
/// no answer.
void append_kept_answer(std::string& out, const PairCase& pair, std::string_view collider,
                        const FrameNumber& number, const KeptAnswer& answer);

}  // namespace manifuzz
