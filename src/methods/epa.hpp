#pragma once

#include "methods/gjk.hpp"

namespace manifuzz::methods {

/// The outline of a part of the difference that is being expanded: vertices of it, counter-clockwise.
/// Two are the outline of a segment, there and back.
struct Outline {
  /// All pairs of vertices that there are.
  static constexpr int kMax = kMaxVertices * kMaxVertices;

  std::array<SupportPair, kMax> vertices;  ///< `count` of them
  std::array<double, kMax> squared;        ///< the distance's of the edge that begins there
  int count = 0;

  /// The vertex after this one, counted round.
  int next(int k) const { return k + 1 < count ? k + 1 : 0; }
  /// Whether it has that vertex.
  bool has(SupportPair pair) const {
    for (int k = 0; k < count; ++k) {
      if (vertices[k] == pair) return true;
    }
    return false;
  }
  /// The edge whose inside or end is nearest to the origin, the first of equals.
  int nearest() const {
    int nearest = 0;
    for (int k = 1; k < count; ++k) {
      if (squared[k] < squared[nearest]) nearest = k;
    }
    return nearest;
  }
};

/// What EPA finds: the edge of the difference's outline that is nearest to the origin, in
/// counter-clockwise order; one vertex where the difference is a point.
struct EpaResult {
  Simplex edge;
  int iterations = 0;  ///< how many supports were asked for
};

/// Another vertex of the difference than a given one, if it has any.
template <class Scalar>
SupportPair another_vertex(const Difference<Scalar>& difference, SupportPair vertex) {
  for (const Vector2<double>& direction :
       {Vector2<double>(1, 0), Vector2<double>(-1, 0), Vector2<double>(0, 1),
        Vector2<double>(0, -1)}) {
    const SupportPair support = difference.support(direction);
    const Vector2<double> between = difference.edge(vertex, support);
    if (between.x() != 0 || between.y() != 0) return support;
  }
  return vertex;
}

/// Where to begin: GJK's last simplex, counter-clockwise, of vertices that are not all at one place.
template <class Scalar>
Outline first_outline(const Difference<Scalar>& difference, const Simplex& from) {
  Outline outline;
  const auto& p = from.vertices;
  const bool is_flat =
      from.count < 3 || cross(difference.edge(p[0], p[1]), difference.edge(p[0], p[2])) == 0;
  outline.vertices[0] = p[0];
  outline.count = 2;
  if (is_flat) {
    outline.vertices[1] = another_vertex(difference, p[0]);
    if (outline.vertices[1] == p[0]) outline.count = 1;
    return outline;
  }
  outline.count = 3;
  const bool turns_left = cross(difference.edge(p[0], p[1]), difference.edge(p[0], p[2])) > 0;
  outline.vertices[1] = turns_left ? p[1] : p[2];
  outline.vertices[2] = turns_left ? p[2] : p[1];
  return outline;
}

/// The expanding polytope algorithm (van den Bergen, 2001) in the plane: from a simplex that holds
/// the origin, asks for the vertex that is farthest beyond the outline's nearest edge and puts it
/// between that edge's ends, until none is beyond.
///
/// Nearest by the edges themselves and not by their lines: rounding turns a tiny edge by any angle,
/// but moves its places by no more than itself. It stops by no count, and ends: each step adds a
/// vertex to the outline that it did not have, and there are finitely many.
template <class Scalar>
EpaResult epa(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
              const Simplex& from) {
  const Difference<Scalar> difference(a, b);
  Outline outline = first_outline(difference, from);
  if (outline.count == 1) return {{{outline.vertices[0]}, 1}, 0};
  const auto measure = [&](int k) {
    outline.squared[k] = nearest_of_edge(difference, outline.vertices[k],
                                         outline.vertices[outline.next(k)])
                             .squared;
  };
  for (int k = 0; k < outline.count; ++k) measure(k);
  for (int iterations = 1;; ++iterations) {
    const int nearest = outline.nearest();
    const SupportPair first = outline.vertices[nearest];
    const SupportPair second = outline.vertices[outline.next(nearest)];
    const Vector2<double> inward =
        counter_clockwise_quarter(difference.edge(first, second));
    const SupportPair support = difference.support(inward);
    const bool is_beyond = inward.dot(difference.edge(first, support)) < 0;
    if (!is_beyond || outline.has(support)) return {{{first, second}, 2}, iterations};
    for (int k = outline.count; k > nearest + 1; --k) {
      outline.vertices[k] = outline.vertices[k - 1];
      outline.squared[k] = outline.squared[k - 1];
    }
    ++outline.count;
    outline.vertices[nearest + 1] = support;
    measure(nearest);
    measure(nearest + 1);
  }
}

}  // namespace manifuzz::methods
