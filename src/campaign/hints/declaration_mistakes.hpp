#pragma once

#include "campaign/hints/answer_mistakes.hpp"

// Mistakes in what is declared: the answer is right by another declaration.

namespace manifuzz {

/// One in double takes the normals that it is given, which are floats.
MaybeUndone with_float_normals(const AskedCase& asked);
/// It rounds in world coordinates.
MaybeUndone in_world(const AskedCase& asked);
/// Normals are those of world vertices.
MaybeUndone with_world_vertices(const AskedCase& asked);
/// Rotations reach it as angles.
MaybeUndone with_angles(const AskedCase& asked);
/// It rounds to float, where it says, or in the world.
MaybeUndone in_float(const AskedCase& asked);
MaybeUndone in_float_in_world(const AskedCase& asked);

}  // namespace manifuzz
