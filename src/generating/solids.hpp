#pragma once

#include <initializer_list>

#include "base/random.hpp"
#include "generating/drafts.hpp"

namespace manifuzz {

/// A core with its radius on the drawing board: a point, a segment or a polygon.
struct Solid {
  Outline outline;
  double radius = 0;
  Rounding rounding = Rounding::round;
};

enum class Family { circle, segment, capsule, rounded, polygon };

Outline point();

/// Along x, its middle at the origin.
Outline segment(double length);

/// Between a quarter and twice the usual size.
Solid draw_solid(Random& random, Family family);

/// A random solid of one of these families, each equally often.
Solid any_of(Random& random, std::initializer_list<Family> families);

/// The core's span and twice the radius.
double size_of(const Solid& solid);

/// A segment that hangs from its end at the origin, its axis off from -y by an angle of sine
/// `lean`, from -1 to 1.
Outline end_up(double length, double lean);

/// Turned so that some place of it is at the origin, where +y is among its normals.
Outline place_up(Random& random, const Outline& outline);

/// A drawing with A below and B, turned upside down, above; both at the origin.
Draft facing(const Outline& a, const Outline& b);

/// Gives the drawing the solids' radii and corners, and moves B up by `distance`, a length.
void set_apart(Draft& draft, const Solid& a, const Solid& b, double distance);

}  // namespace manifuzz
