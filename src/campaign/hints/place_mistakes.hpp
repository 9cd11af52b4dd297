#pragma once

#include "campaign/hints/answer_mistakes.hpp"

// Mistakes in where contact points lie: on the incident edge they are expected, or, of round
// shapes, on the incident surface.

namespace manifuzz {

/// Points lie halfway between both surfaces.
MaybeUndone from_midpoints(const AskedCase& asked);
/// Points lie on this body's surface.
MaybeUndone from_surface_of(Side side, const AskedCase& asked);
/// Points lie on the surface of the body whose face is the reference.
MaybeUndone from_reference(const AskedCase& asked);

}  // namespace manifuzz
