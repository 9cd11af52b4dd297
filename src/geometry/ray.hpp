#pragma once

#include <optional>

#include "geometry/convex_polygon.hpp"

namespace manifuzz {

/// A straight way in the world, from a point to `from` + `along`.
struct Ray {
  Vector2<float> from{0, 0};   ///< where it begins
  Vector2<float> along{0, 0};  ///< from where it begins to where it ends
};

/// Where a ray meets a shape.
struct RayHit {
  double share = 0;              ///< of the way up to there, 0 to 1
  Vector2<double> normal{0, 0};  ///< unit, out of the shape; (0, 0) where the ray begins inside
};

/// The first place of a ray in a shape that stands at `pose`; none where it goes past. A radius is
/// round to rays, at sharp corners, too. In double, on the floats as they are: the core is R v + p,
/// whatever the length of its rotation. Let E be the sum of |p - from|, |along|, reach and radius,
/// in the world, and B = 32 roundoffs of a double times E.
///
/// With a radius, and of a segment, the place lies within B of the outline, and what lies before it
/// on the ray, or all of a ray without a hit, is nowhere deeper in the shape than B. Of a polygon
/// without one, that holds for the lines of its faces: the place is past none by more than B, and
/// within B of one; so within B / sin(half the sharpest corner's angle) of the outline. Where a ray
/// begins inside, the place is its beginning.
///
/// (A vertex of the core is off by 3 roundoffs of E, products with a normal by 9 more, the place on
/// the ray by 4; a circle's half chord moves the place along the circle, and off it no farther than
/// the chord's distance is off.)
std::optional<RayHit> cast_ray(const ConvexPolygon<float>& shape, const Pose<float>& pose,
                               const Ray& ray);

}  // namespace manifuzz
