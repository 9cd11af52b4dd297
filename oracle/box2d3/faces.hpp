#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/vector.hpp"

namespace manifuzz::ledger_of::box2d3 {

// What Box2D 3 and phaser-box2d look for among faces and edges, each in its own scalar.

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

/// Where two edges are nearest, each place a share of its edge from its first end.
template <class Scalar>
struct NearestShares {
  Scalar share1 = 0;             ///< of the first edge
  Scalar share2 = 0;             ///< of the second
  bool is_beyond_range = false;  ///< a product of squared lengths is, so that nothing is a number

  bool are_ends() const { return is_end(share1) && is_end(share2); }
  static bool is_end(Scalar share) { return share == 0 || share == 1; }
};

/// b2SegmentDistance, of edges from p1 along d1 and from p2 along d2.
template <class Scalar>
NearestShares<Scalar> nearest_shares(const Vector2<Scalar>& p1, const Vector2<Scalar>& d1,
                                     const Vector2<Scalar>& p2, const Vector2<Scalar>& d2) {
  const Vector2<Scalar> r = p1 - p2;
  const Scalar dd1 = d1.dot(d1);
  const Scalar dd2 = d2.dot(d2);
  const Scalar rd1 = r.dot(d1);
  const Scalar rd2 = r.dot(d2);
  const Scalar d12 = d1.dot(d2);
  const Scalar denominator = dd1 * dd2 - d12 * d12;
  const auto in_edge = [](Scalar share) { return std::clamp(share, Scalar(0), Scalar(1)); };
  NearestShares<Scalar> found;
  if (denominator != 0) found.share1 = in_edge((d12 * rd2 - rd1 * dd2) / denominator);
  // Finite cores can give infinity less infinity, or over infinity.
  found.is_beyond_range = std::isnan(found.share1);
  found.share2 = (d12 * found.share1 + rd2) / dd2;
  if (found.share2 < 0) return {in_edge(-rd1 / dd1), 0, found.is_beyond_range};
  if (found.share2 > 1) return {in_edge((d12 - rd1) / dd1), 1, found.is_beyond_range};
  return found;
}

}  // namespace manifuzz::ledger_of::box2d3
