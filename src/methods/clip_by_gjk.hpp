#pragma once

#include "clipping/collide.hpp"
#include "methods/nearest_features.hpp"

namespace manifuzz::methods {

/// The manifold of two mitred polygons in one frame: which faces touch by GJK and EPA, the points
/// by clipping. `hint` is what the last step left, and is left for the next.
template <class Scalar>
Manifold<Scalar> clip_by_gjk(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                             Simplex& hint) {
  const NearestFeatures<Scalar> nearest = nearest_features(a, b, hint);
  if (nearest.apartness == Apartness::separated) return {};
  return clipping::contact_of_faces(a, b, nearest.faces.of_a, nearest.faces.of_b, Scalar(0));
}

}  // namespace manifuzz::methods
