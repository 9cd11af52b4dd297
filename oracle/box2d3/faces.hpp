#pragma once

#include <algorithm>
#include <limits>

#include "geometry/vector.hpp"

namespace manifuzz::ledger_of::box2d3 {

// What Box2D 3 and phaser-box2d look for among a polygon's faces, each in its own scalar.

template <class Scalar>
struct BestFace {
  int index = 0;
  Scalar separation = -std::numeric_limits<Scalar>::max();
};

/// b2FindMaxSeparation.
template <class Scalar, class Polygon>
BestFace<Scalar> best_face(const Polygon& on, const Polygon& of) {
  BestFace<Scalar> best;
  for (int i = 0; i < on.count; ++i) {
    Scalar nearest = std::numeric_limits<Scalar>::max();
    for (int j = 0; j < of.count; ++j) {
      nearest = std::min(nearest, on.normals[i].dot(of.vertices[j] - on.vertices[i]));
    }
    if (nearest > best.separation) best = {i, nearest};
  }
  return best;
}

template <class Scalar, class Polygon>
int most_opposed(const Polygon& of, const Vector2<Scalar>& normal) {
  int found = 0;
  for (int i = 1; i < of.count; ++i) {
    if (normal.dot(of.normals[i]) < normal.dot(of.normals[found])) found = i;
  }
  return found;
}

}  // namespace manifuzz::ledger_of::box2d3
