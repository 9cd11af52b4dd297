#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "geometry/sequence.hpp"

namespace manifuzz {

class JsonView;

/// The value of the key "format" in a sequence.
inline constexpr std::string_view kSequenceFormat = "manifuzz/sequence/1";

/// The most frames that a sequence may have, so that no input takes all memory.
inline constexpr std::size_t kFramesMax = 2048;

/// Whether an object is a sequence: by its format, or, without one, by its frames.
bool is_sequence(const JsonView& object);

/// The shapes and the frames of an object, whose keys are checked elsewhere: {"a": {"vertices":
/// [[x, y], ...], "radius": 0}, "b": ..., "frames": [{"a": [x, y, cos, sin], "b": ...}, ...]}.
/// Throws UserError that begins with a path.
Sequence read_sequence(const JsonView& object);

/// Appends a sequence as one line, without the line's end.
void append_case_line(std::string& out, const Sequence& sequence);

/// Appends the same as a corpus file begins: a line for each shape and each frame, and the last
/// brace not yet.
void append_case_start(std::string& out, const Sequence& sequence);

}  // namespace manifuzz
