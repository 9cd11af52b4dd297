#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "geometry/pair_case.hpp"

namespace manifuzz {

// A case as bytes of a fixed layout, for fuzzers that know nothing but bytes: body A, then body B.
// Floats are IEEE 754 binary32 in little-endian order, the very bits of the case.
//
//   at  bytes  of each body
//    0      1  number of vertices, 1 to 8
//    1      1  1: corners are round, as those of circles and capsules always are; 0: mitred
//    2      2  nothing
//    4     64  eight vertices x, y in the body's own frame, of which those beyond the number are 0
//   68      4  radius
//   72      8  position x, y
//   80      8  rotation (cos, sin)

inline constexpr std::size_t kBodyBytes = 88;
inline constexpr std::size_t kCaseBytes = 2 * kBodyBytes;

/// Writes the case.
void encode_case(const PairCase& pair, std::span<std::uint8_t, kCaseBytes> to);

/// The case that the bytes are, or none where there are more or fewer, or where it is not valid.
/// Bytes that hold nothing may be anything.
std::optional<PairCase> decode_case(std::span<const std::uint8_t> bytes);

}  // namespace manifuzz
