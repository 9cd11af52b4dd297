#pragma once

#include "collider/used_shapes.hpp"

namespace manifuzz::exact {

/// The Hausdorff distance H between a convex polygon and what was made of it, both filled and in
/// the polygon's own frame: how far the farthest vertex of either lies from the other, each with
/// its radius around it, by which corners are taken to be round. A world length.
class Alteration {
 public:
  Alteration(const ConvexPolygon<float>& polygon, const UsedVertices& used);

  /// As near as double says it.
  double distance() const { return distance_; }
  /// Whether H is larger than a length >= 0; exact.
  bool exceeds(double length) const;

 private:
  const ConvexPolygon<float>* polygon_;
  const UsedVertices* used_;
  double grown_ = 0;  ///< the radius used, less the polygon's
  double distance_ = 0;
};

}  // namespace manifuzz::exact
