#pragma once

#include "campaign/hints/mistakes.hpp"

// Mistakes in what an answer says of normals and depths, undone in the answer.

namespace manifuzz {

using MaybeUndone = std::optional<Undone>;

/// The normal points from B to A.
MaybeUndone with_normal_turned_about(const AskedCase& asked);

/// Depths are below zero where shapes overlap.
MaybeUndone with_depths_negated(const AskedCase& asked);
/// Depths are the cores' separations.
MaybeUndone with_separations_as_depths(const AskedCase& asked);
/// Depths leave the radii out.
MaybeUndone with_radii_added_to_depths(const AskedCase& asked);
/// Depths have the radii twice.
MaybeUndone with_radii_taken_from_depths(const AskedCase& asked);

/// y points down in positions and normals.
MaybeUndone with_y_negated(const AskedCase& asked);

/// The figures of an answer that are in a body's frame and should be in the world.
enum class InFrame { all, positions, normal };
MaybeUndone from_frame_of(Side side, InFrame what, const AskedCase& asked);
/// Positions in the world are given as if they were in A's frame.
MaybeUndone from_world(const AskedCase& asked);

}  // namespace manifuzz
