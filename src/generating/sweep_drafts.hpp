#pragma once

#include "generating/drafts.hpp"

namespace manifuzz {

// What sweeps draw from: everything that no knob turns is benign.

/// A regular polygon, stretched a little and turned, between 0.5 and 3 across.
Outline benign_outline(Random& random, int most = kMaxVertices);

/// The same with a face on y = 0, facing +y, or with a corner up at the origin.
Outline benign_partner(Random& random);

/// Gives the outline axes of its own; nothing moves.
void give_own_axes(Random& random, Sketch& sketch);

/// Touching or nearly so, as deep as a quarter of `unit`; one in four rounded.
void meet(Random& random, Draft& draft, double unit);
inline void meet(Random& random, Draft& draft) {
  meet(random, draft, span(draft));
}

/// Turns the drawing in the world and stands it up to two of its sizes from the origin. B's
/// vertices take up what rounding its position leaves.
void stand_near(Random& random, Draft& draft);

/// By how much the gap of a settled pair is off, as a share of the gap asked for.
double gap_error(const PairCase& pair, double gap);

}  // namespace manifuzz
