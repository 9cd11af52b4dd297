#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <variant>
#include <vector>

#include "collider/collider.hpp"
#include "geometry/angular_disc.hpp"

namespace manifuzz {

/// With which frame the normal of a kept point turns.
enum class TravelsWith { a, b, world };

/// A contact point that is kept over frames, as it is in one of them.
struct KeptPoint {
  int id = 0;                      ///< the same in every frame in which it is the same point
  int born = 0;                    ///< the frame in which detection last gave it
  Vector2<double> anchor_a{0, 0};  ///< the point on A, in A's own frame
  Vector2<double> anchor_b{0, 0};  ///< the point on B, in B's own frame
  Vector2<double> normal{0, 0};    ///< unit, from A to B, in the world, as it is in this frame
  TravelsWith travels_with = TravelsWith::a;
  double depth = 0;  ///< along the normal, a world length; negative across a gap

  friend bool operator==(const KeptPoint&, const KeptPoint&) = default;
};

/// What is known of a contact in one frame.
struct KeptManifold {
  std::vector<KeptPoint> points;
};

/// How large a shape is taken to be: how far it reaches from its own origin, radius included, or
/// Bullet's angular motion disc.
enum class ShapeMeasure { reach, angular_disc };

/// A length that depends on the shapes: `absolute`, a world length, plus `relative` times the
/// smaller shape's measure.
struct ShapeLength {
  double absolute = 0;
  double relative = 0;
  ShapeMeasure measure = ShapeMeasure::reach;

  double of(const PairCase& pair) const {
    return absolute + relative * std::min(measured(pair.a.polygon), measured(pair.b.polygon));
  }

 private:
  double measured(const ConvexPolygon<float>& shape) const {
    return measure == ShapeMeasure::reach ? reach(shape) + static_cast<double>(shape.radius)
                                          : angular_disc(polygon_cast<double>(shape));
  }
};

/// Since when a point's drift and turn count.
enum class StaleSince { birth, refresh };

/// By which of their anchors two points are near each other: those on both bodies, the nearer ones,
/// those on A, those on B.
enum class MatchBy { both, either, a, b };

/// What a collider that keeps points declares of them. Without a limit it is infinite.
struct Keeping {
  ShapeLength gap;    ///< the greatest across which a point is kept
  ShapeLength drift;  ///< how far its anchors may have slid on each other, across the normal
  double turn = std::numeric_limits<double>::infinity();  ///< of B against A, in radians
  StaleSince since = StaleSince::birth;
  ShapeLength match;  ///< within which a new point takes an old one's place
  MatchBy match_by = MatchBy::both;
  int points_max = 2;
};

/// There is one each frame: no contact is one without points.
using KeptAnswer = std::variant<KeptManifold, Unsupported, Lost>;

/// A collider with a memory. What it says of a point at its birth is judged as `declaration` has
/// it: of one that claims `point` each new point is the deepest, of one that claims `manifold` each
/// is a point of some right contact. What becomes of a point is judged by `keeping`.
struct SequenceCollider {
  Declaration declaration;
  Keeping keeping;
  /// Forgets everything; the function that it gives is asked frame after frame.
  std::function<std::function<KeptAnswer(const PairCase& frame)>()> begin;

  bool is_isolated = false;  ///< it runs in a process of its own
};

}  // namespace manifuzz
