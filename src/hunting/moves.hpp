#pragma once

#include <span>
#include <string_view>

#include "base/random.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A way to make a case of another one. `mate` is a second one, from which it may take a part. What
/// comes need not be valid.
struct Move {
  std::string_view name;
  void (*make)(Random& random, PairCase& pair, const PairCase& mate);
};

/// Moves of single numbers: by ulps to halves, equal to another, to 0, to a power of two.
std::span<const Move> moves_of_numbers();
/// Moves of shapes: vertices in and out, onto a line, lengths alike, radii, kinds, sizes.
std::span<const Move> moves_of_shapes();
/// Moves of places: rotations, faces parallel, contact, side planes, ties, far away; bodies swapped
/// and taken from the mate.
std::span<const Move> moves_of_places();

/// Where a face separates the shapes, moves one along a face to contact, or their middles together
/// or closer. Another face may still keep them apart.
void close_gap(Random& random, PairCase& pair);

}  // namespace manifuzz
