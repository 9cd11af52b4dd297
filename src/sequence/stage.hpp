#pragma once

#include "base/random.hpp"
#include "generating/solids.hpp"
#include "geometry/sequence.hpp"

namespace manifuzz {

/// Two solids that meet on the drawing board: A below, B above, the contact near the origin and its
/// normal along +y.
struct Meeting {
  ConvexPolygon<float> a;  ///< in its own frame
  ConvexPolygon<float> b;
  Pose<double> at_a;  ///< of its frame, in the drawing
  Pose<double> at_b;
  double size = 0;    ///< the smaller solid's
  double height = 0;  ///< by how much B is up from where the outlines touch
  double left = 0;    ///< where the contact ends, along x
  double right = 0;   ///< its other end; the same where it is one place
};

/// A polygon, half the time with sharp corners, a circle, a segment or a capsule.
Solid any_solid(Random& random);

/// The solid in another size.
Solid scaled(const Solid& solid, double scale);

/// Some face up, or a place of a point.
Outline side_up(Random& random, const Outline& outline);

/// As these outlines stand, A's below and B's, which is turned upside down, above; `gap` apart.
/// Each gets axes of its own. None where floats spoil a shape.
std::optional<Meeting> meeting_of(Random& random, const Solid& a, const Solid& b, double gap);

/// How a body is moved in the drawing: turned about a place, then moved.
struct Move {
  Vector2<double> turn{1, 0};  ///< as (cos, sin)
  Vector2<double> about{0, 0};
  Vector2<double> by{0, 0};
};

/// Writes down where two bodies that meet stand, frame after frame.
class Stage {
 public:
  /// The drawing stands anywhere in the world.
  Stage(Random& random, const Meeting& meeting);

  const Meeting& meeting() const { return meeting_; }
  /// Turns the drawing in the world about its origin, and moves it.
  void carry(const Vector2<double>& turn, const Vector2<double>& by);
  /// One more frame, with the bodies moved from where they met.
  void show(const Move& a, const Move& b);
  /// All of them, A and B exchanged half the time.
  Sequence finished(Random& random) const;

 private:
  Meeting meeting_;
  Pose<double> world_;
  std::vector<FramePoses> frames_;
};

}  // namespace manifuzz
