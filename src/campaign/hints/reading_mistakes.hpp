#pragma once

#include "campaign/hints/answer_mistakes.hpp"

// Mistakes in how a case is read: the answer is right for the shapes as the collider saw them.

namespace manifuzz {

/// What is as the case has it: where points are in the world, or where they are in A's frame.
enum class SeenFrom { world, frame_of_a };

/// (cos, sin), which are not quite unit, are made so.
MaybeUndone with_unit_rotations(SeenFrom from, const AskedCase& asked);
/// Bodies are turned the other way.
MaybeUndone with_rotations_backwards(SeenFrom from, const AskedCase& asked);
/// Bodies are turned by so many times their angle.
MaybeUndone with_angles_times(double factor, SeenFrom from, const AskedCase& asked);
/// y of the vertices is negated, each in its body's frame.
MaybeUndone with_vertices_flipped(const AskedCase& asked);
/// Decimals that stand for floats are taken for doubles.
MaybeUndone with_decimals_as_doubles(SeenFrom from, const AskedCase& asked);
/// Radii are so many times as large.
MaybeUndone with_radii_times(float factor, const AskedCase& asked);

}  // namespace manifuzz
