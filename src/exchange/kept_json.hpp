#pragma once

#include <map>
#include <optional>
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

/// Appends the line that a program which keeps points is asked a frame with: a case's, with the
/// keys "sequence" and "frame" before the others.
void append_frame_line(std::string& out, const PairCase& pair, const FrameNumber& number,
                       ScalarType scalar);

/// Reads what a program answers to the frames of one sequence, in order: {"points": [...]}, each
/// point with "position" (in the world) or "local" (in A's frame) on A's surface or with both
/// "anchor_a" and "anchor_b", "depth", and "normal", unless one beside the points is that of all.
/// Without "id" a point is new in its frame; without "born" it is born where its id comes first;
/// without "travels_with" its normal turns with A. Unknown keys are ignored.
class KeptReader {
 public:
  /// `normal_from_b`: normals point from B to A.
  explicit KeptReader(bool normal_from_b = false) : normal_from_b_(normal_from_b) {}

  /// The answer to the next frame. Throws UserError that begins with a path.
  KeptAnswer read(const JsonView& object, const PairCase& pair);

 private:
  KeptPoint read_point(const JsonView& object, const std::optional<JsonView>& normal_of_all,
                       const PairCase& pair);

  bool normal_from_b_;
  int frame_ = 0;
  int unnamed_ = 0;            ///< points without an id, so far
  std::map<int, int> born_{};  ///< the frame in which an id came first
};

/// What a program declares of the points that it keeps: {"gap": length, "drift": length, "turn":
/// radians, "since": "birth"|"refresh", "match": length, "match_by": "both"|"either"|"a"|"b",
/// "points_max": n}, a length being a number or {"absolute": x, "relative": x, "measure":
/// "reach"|"angular_disc"}. Throws UserError that begins with a path.
Keeping read_keeping(const JsonView& object);

}  // namespace manifuzz
