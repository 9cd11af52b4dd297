#pragma once

#include <utility>

#include "methods/gjk.hpp"

namespace manifuzz::methods {

/// The outline of a part of the difference that is being expanded: vertices of it,
/// counter-clockwise. Two are the outline of a segment, there and back.
struct Outline {
  /// All pairs of vertices that there are.
  static constexpr int kMax = kMaxVertices * kMaxVertices;

  std::array<SupportPair, kMax> vertices;  ///< `count` of them
  std::array<double, kMax> squared;        ///< the distance's of the edge that begins there
  int count = 0;                           ///< of both
  std::uint64_t added = 0;                 ///< a bit for each pair that it has, or had

  /// The vertex after this one, counted round.
  int next(int k) const { return k + 1 < count ? k + 1 : 0; }
  /// The vertex before this one, counted round.
  int previous(int k) const { return k > 0 ? k - 1 : count - 1; }
  /// The edge whose inside or end is nearest to the origin, the first of equals.
  int nearest() const {
    int nearest = 0;
    for (int k = 1; k < count; ++k) {
      if (squared[k] < squared[nearest]) nearest = k;
    }
    return nearest;
  }
  /// Puts a vertex before the one of this index. False where it has, or had, that vertex.
  bool insert(int at, SupportPair pair) {
    const std::uint64_t bit = bit_of(pair);
    if ((added & bit) != 0) return false;
    added |= bit;
    for (int k = count++; k > at; --k) {
      vertices[k] = vertices[k - 1];
      squared[k] = squared[k - 1];
    }
    vertices[at] = pair;
    return true;
  }
  /// Takes a vertex out.
  void erase(int at) {
    for (int k = at + 1; k < count; ++k) {
      vertices[k - 1] = vertices[k];
      squared[k - 1] = squared[k];
    }
    --count;
  }
};

/// What EPA finds: the edge of the difference's outline that is nearest to the origin, in
/// counter-clockwise order; one vertex where the difference is a point.
struct EpaResult {
  Simplex edge;                  ///< of 2 vertices, or 1
  int iterations = 0;            ///< how many supports were asked for
  Vector2<double> inward{0, 0};  ///< from the origin to it, of any length
};

/// Another vertex of the difference than a given one, if it has any.
template <class Scalar>
SupportPair another_vertex(const Difference<Scalar>& difference, SupportPair vertex) {
  for (const Vector2<double>& direction : {Vector2<double>(1, 0), Vector2<double>(-1, 0),
                                           Vector2<double>(0, 1), Vector2<double>(0, -1)}) {
    const SupportPair support = difference.support(direction);
    const Vector2<double> between = difference.edge(vertex, support);
    if (between.x() != 0 || between.y() != 0) return support;
  }
  return vertex;
}

/// Twice the area of a triangle of the difference: positive where its corners turn left.
template <class Scalar>
double turn_at(const Difference<Scalar>& difference, SupportPair before, SupportPair corner,
               SupportPair after) {
  return cross(difference.edge(before, corner), difference.edge(corner, after));
}

/// Measures the edge that begins at a vertex of the outline.
template <class Scalar>
void measure_edge(const Difference<Scalar>& difference, Outline& outline, int k) {
  const NearestFeature nearest =
      nearest_of_edge(difference, outline.vertices[k], outline.vertices[outline.next(k)]);
  outline.squared[k] = nearest.squared;
}

/// Where to begin: GJK's last simplex, counter-clockwise; of a vertex alone, an edge from there.
template <class Scalar>
Outline first_outline(const Difference<Scalar>& difference, const Simplex& from) {
  Outline outline;
  const auto& p = from.vertices;
  for (int k = 0; k < from.count; ++k) outline.insert(k, p[k]);
  if (from.count == 1) outline.insert(1, another_vertex(difference, p[0]));
  if (from.count == 3 && turn_at(difference, p[0], p[1], p[2]) < 0) {
    std::swap(outline.vertices[1], outline.vertices[2]);
  }
  for (int k = 0; k < outline.count; ++k) measure_edge(difference, outline, k);
  return outline;
}

/// Takes out the neighbours of a vertex that it leaves behind: where GJK began need not be a corner
/// of the difference.
template <class Scalar>
void make_convex(const Difference<Scalar>& difference, Outline& outline, int at) {
  const auto turn = [&](int k) {
    return turn_at(difference, outline.vertices[outline.previous(k)], outline.vertices[k],
                   outline.vertices[outline.next(k)]);
  };
  for (int k = outline.next(at); outline.count > 3 && turn(k) <= 0; k = outline.next(at)) {
    outline.erase(k);
    if (k < at) --at;
  }
  for (int k = outline.previous(at); outline.count > 3 && turn(k) <= 0; k = outline.previous(at)) {
    outline.erase(k);
    if (k < at) --at;
  }
  measure_edge(difference, outline, outline.previous(at));
  measure_edge(difference, outline, at);
}

/// The expanding polytope algorithm (van den Bergen, 2001) in the plane: from a simplex that holds
/// the origin, asks for the vertex that is farthest beyond the outline's nearest edge and puts it
/// between that edge's ends, until none is beyond.
///
/// Nearest by the edges themselves and not by their lines: rounding turns a tiny edge by any angle,
/// but moves its places by no more than itself. It stops by no count, and ends: each step adds a
/// vertex that the outline never had, and there are finitely many.
template <class Scalar>
EpaResult epa(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b, const Simplex& from) {
  const Difference<Scalar> difference(a, b);
  Outline outline = first_outline(difference, from);
  if (outline.count == 1) return {from, 0, difference.vertex(from.vertices[0])};
  for (int iterations = 1;; ++iterations) {
    const int nearest = outline.nearest();
    const SupportPair first = outline.vertices[nearest];
    const SupportPair second = outline.vertices[outline.next(nearest)];
    const Vector2<double> inward = counter_clockwise_quarter(difference.edge(first, second));
    const SupportPair support = difference.support(inward);
    const bool is_beyond = inward.dot(difference.edge(first, support)) < 0;
    if (!is_beyond || !outline.insert(nearest + 1, support)) {
      return {{{first, second}, 2}, iterations, inward};
    }
    make_convex(difference, outline, nearest + 1);
  }
}

}  // namespace manifuzz::methods
