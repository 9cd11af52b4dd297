#pragma once

#include "generating/placing.hpp"
#include "generating/regime.hpp"

namespace manifuzz {

// How two outlines meet. In all but `free_pair` the drawing has A below and B above, the contact
// near the origin and its normal along +y. The outlines keep the size they come with.

/// B in any turn, met from any side: each outline keeps its own axes.
Draft free_pair(Random& random, const Outline& a, const Outline& b);

/// Two facing faces that overlap, B's turned by `tilt`, the sine over the cosine of the angle.
Draft face_to_face(Random& random, const Outline& a, const Outline& b, double tilt);

/// A's face, pierced by a corner of B.
Draft corner_to_face(Random& random, const Outline& a, const Outline& b);

/// A corner of A under a corner of B.
Draft corner_to_corner(Random& random, const Outline& a, const Outline& b);

/// One of the four, A and B exchanged half the time.
Draft any_meeting(Random& random, const Outline& a, const Outline& b);

/// The same of two outlines from `sized_outline`.
Draft any_meeting(Random& random);

/// A random outline of random count, between a quarter and twice the usual size.
Outline sized_outline(Random& random, int most = kMaxVertices);

/// The outline with a face on y = 0, facing +y, or with a corner up at the origin, but not within
/// `margin` (a share) of a face's ends, or of a corner's two normals.
Outline face_or_corner_up(Random& random, const Outline& outline, double margin);

/// The draft, or A and B exchanged.
Draft maybe_swapped(Random& random, const Draft& draft);

/// The smaller outline's span.
double span(const Draft& draft);

/// About half the time none; else Box2D's default (0.01 `unit`) or something small, mostly of both
/// alike. The context's radius comes before all.
void draw_radii(Random& random, const GenerationContext& context, Draft& draft, double unit = 1);

/// A gap as a share of the size: mostly touching, the rest near, as few as asked beyond that.
double draw_gap(Random& random, double beyond = 0);

/// Radii and gap, by the draft's size.
void aim(Random& random, const GenerationContext& context, Draft& draft, double unit = 1);

/// Any rotation, and a position of up to ten sizes, often the origin.
Pose<double> random_world(Random& random, double size);

/// Moves the origin of each outline off its middle now and then, and stands the drawing anywhere.
void stand(Random& random, Draft& draft);

/// Either keeps the drawing's frame, at the world's origin, so that floats near the contact are
/// dense and the construction is exact; or gives each polygon a frame of its own and stands it
/// anywhere.
void frame(Random& random, Draft& draft, double exact = 0.5);

}  // namespace manifuzz
