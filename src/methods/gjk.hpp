#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "clipping/nearest.hpp"

/// The article's other methods than clipping.
namespace manifuzz::methods {

/// A vertex of the difference of two cores, B - A: B's vertex as seen from A's, by their indices.
struct SupportPair {
  unsigned char a = 0;  ///< A's vertex
  unsigned char b = 0;  ///< B's

  friend bool operator==(const SupportPair&, const SupportPair&) = default;
};

/// A bit of its own for each pair of vertices.
constexpr std::uint64_t bit_of(SupportPair pair) {
  static_assert(kMaxVertices * kMaxVertices <= 64);
  return std::uint64_t(1) << (pair.a * kMaxVertices + pair.b);
}

/// 0 to 3 vertices of the difference, plain data: what one step leaves to the next one as its hint,
/// both where to begin and which support to ask for first. Any indices will do, of other shapes
/// too: a bad hint costs iterations and nothing else.
struct Simplex {
  std::array<SupportPair, 3> vertices{};  ///< `count` of them
  int count = 0;                          ///< 0: there is none

  friend bool operator==(const Simplex&, const Simplex&) = default;
};

/// The difference of two cores that stand in one frame, B - A: its place nearest to the origin is
/// the way from A to B. Everything is computed in double, from differences of vertices, which keeps
/// rounding relative to what they are far from each other. Of floats every sign is then exact but
/// for the last of many digits.
template <class Scalar>
class Difference {
 public:
  /// Both must outlive it.
  Difference(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) : a_(a), b_(b) {}

  /// From A's vertex to B's.
  Vector2<double> vertex(SupportPair p) const {
    return (wide(b_.vertices[p.b]) - wide(a_.vertices[p.a]));
  }
  /// From a vertex of the difference to another, by the cores' own edges: these are told better
  /// than places that are far from the origin.
  Vector2<double> edge(SupportPair p, SupportPair q) const {
    return (wide(b_.vertices[q.b]) - wide(b_.vertices[p.b])) -
           (wide(a_.vertices[q.a]) - wide(a_.vertices[p.a]));
  }
  /// The vertex least far along a direction of any length: A's farthest and B's least far, the
  /// first of equals.
  SupportPair support(const Vector2<double>& direction) const {
    return {farthest<-1>(a_, direction), farthest<1>(b_, direction)};
  }
  /// Whether the indices are of vertices that there are.
  bool has(SupportPair p) const { return p.a < a_.count && p.b < b_.count; }

 private:
  static Vector2<double> wide(const Vector2<Scalar>& v) { return v.template cast<double>(); }

  /// Against the direction for sign 1, along it for sign -1.
  template <int sign>
  static unsigned char farthest(const ConvexPolygon<Scalar>& core,
                                const Vector2<double>& direction) {
    const Vector2<double> along = sign * direction;
    int index = 0;
    double least = along.dot(wide(core.vertices[0]));
    for (int i = 1; i < core.count; ++i) {
      const double height = along.dot(wide(core.vertices[i]));
      index = height < least ? i : index;
      least = height < least ? height : least;
    }
    return static_cast<unsigned char>(index);
  }

  const ConvexPolygon<Scalar>& a_;
  const ConvexPolygon<Scalar>& b_;
};

/// The feature of a simplex that is nearest to the origin: a vertex, or two with the inside of the
/// edge between them, which has the origin on its right, as an edge of a counter-clockwise outline
/// has what is outside; or the origin is in it.
struct NearestFeature {
  Simplex feature;                                           ///< 1 or 2 vertices, or all 3
  Vector2<double> direction{0, 0};                           ///< to it, of any length
  double squared = std::numeric_limits<double>::infinity();  ///< its distance's square
  bool holds_origin = false;                                 ///< the origin is in it
};

/// The nearest feature of a vertex: the vertex itself.
template <class Scalar>
NearestFeature nearest_of_vertex(const Difference<Scalar>& difference, SupportPair p) {
  const Vector2<double> at = difference.vertex(p);
  const double squared = at.dot(at);
  return {{{p}, 1}, at, squared, squared == 0};
}

/// The nearest feature of an edge: the end in whose region the origin is, or the inside. Distances
/// are taken along the edge's direction from one end, so that tiny edges far away lose nothing.
template <class Scalar>
NearestFeature nearest_of_edge(const Difference<Scalar>& difference, SupportPair p, SupportPair q) {
  const Vector2<double> along = difference.edge(p, q);
  const Vector2<double> from = difference.vertex(p);
  if (along.dot(from) >= 0) return nearest_of_vertex(difference, p);
  if (along.dot(difference.vertex(q)) <= 0) return nearest_of_vertex(difference, q);
  const double area = cross(from, along);
  const Vector2<double> left = counter_clockwise_quarter(along);
  const double squared = area * area / along.dot(along);
  if (area <= 0) return {{{p, q}, 2}, left, squared, area == 0};
  return {{{q, p}, 2}, -left, squared, false};
}

/// The nearest feature of a triangle: the origin is in it, or some edge has it on its outer side. A
/// flat one has no inside.
template <class Scalar>
NearestFeature nearest_of_triangle(const Difference<Scalar>& difference, const Simplex& triangle) {
  const auto& p = triangle.vertices;
  const double turn = cross(difference.edge(p[0], p[1]), difference.edge(p[0], p[2]));
  NearestFeature nearest;
  nearest.feature = {{p[0]}, 1};
  bool is_inside = turn != 0;
  for (int k = 0; k < 3; ++k) {
    const SupportPair from = p[k];
    const SupportPair to = p[k < 2 ? k + 1 : 0];
    const double side = cross(difference.vertex(from), difference.edge(from, to));
    if ((turn > 0 && side >= 0) || (turn < 0 && side <= 0)) continue;
    is_inside = false;
    const NearestFeature of_edge = nearest_of_edge(difference, from, to);
    if (of_edge.squared < nearest.squared) nearest = of_edge;
  }
  if (is_inside) return {triangle, {0, 0}, 0, true};
  return nearest;
}

/// The nearest feature of any simplex that has a vertex.
template <class Scalar>
NearestFeature nearest_of_simplex(const Difference<Scalar>& difference, const Simplex& simplex) {
  const auto& p = simplex.vertices;
  if (simplex.count == 1) return nearest_of_vertex(difference, p[0]);
  if (simplex.count == 2) return nearest_of_edge(difference, p[0], p[1]);
  return nearest_of_triangle(difference, simplex);
}

/// How two cores stand to each other.
enum class Apartness : unsigned char {
  separated,    ///< farther than the limit, along `direction` at least
  apart,        ///< nearest at the simplex
  overlapping,  ///< or touching; the simplex holds the origin
};

/// What GJK finds.
struct GjkResult {
  Apartness apartness = Apartness::apart;  ///< which of the three
  Simplex simplex;                         ///< of 1 or 2 vertices where apart; the next step's hint
  Vector2<double> direction{0, 0};         ///< from A to B, of any length; none where they overlap
  int iterations = 0;  ///< how many supports were asked for, at least 1 where apart
};

/// A hint as a simplex of these cores: the vertex (0, 0) in place of what is none of theirs.
template <class Scalar>
Simplex usable(const Difference<Scalar>& difference, const Simplex& hint) {
  bool is_usable = hint.count >= 1 && hint.count <= 3;
  for (int k = 0; is_usable && k < hint.count; ++k) {
    is_usable = difference.has(hint.vertices[k]);
  }
  return is_usable ? hint : Simplex{{}, 1};
}

/// Whether there is progress, so that the steps end: the least distance so far, and what was asked
/// for since it was found.
class Progress {
 public:
  /// Begins at this square of a distance.
  explicit Progress(double squared) : least_(squared) {}

  /// Whether a step to a feature leads on, by this support: it is nearer, or as near as rounding
  /// tells by a support that was not asked for at this distance. `far` is a vertex of the feature,
  /// f away. A distance d is off by 4 u f: one for each of the differences, the product and the sum
  /// that make the area, 3 u d for the rest; so its square by 14 u d f, for d is at most f, and so
  /// is the other one.
  bool goes_on(double squared, const Vector2<double>& far, SupportPair support) {
    constexpr double off = 14 * std::numeric_limits<double>::epsilon();
    if (squared < least_) {
      least_ = squared;
      asked_ = 0;
    } else if (squared > least_ + off * std::sqrt(least_ * far.dot(far)) ||
               (asked_ & bit_of(support)) != 0) {
      return false;
    }
    asked_ |= bit_of(support);
    return true;
  }

 private:
  double least_;
  std::uint64_t asked_ = 0;
};

/// Gilbert, Johnson and Keerthi's distance of two cores in one frame, radii left out, from a hint
/// on. Stops as soon as a direction separates them by more than `limit`, a length.
///
/// It stops by no count, but where no vertex is less far along the direction to the nearest feature
/// than that is. A step that gains less than the rounding of distances is taken none the less: it
/// turns the direction by up to the root of that. It always ends: the least computed distance
/// strictly decreases, through finitely many simplices; and between two decreases each step asks
/// for another one of finitely many vertices. Where none is gained though a vertex lies on the far
/// side of the origin, the origin is in the simplex but for rounding.
template <class Scalar>
GjkResult gjk(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
              const Simplex& hint = {}, double limit = std::numeric_limits<double>::infinity()) {
  const Difference<Scalar> difference(a, b);
  GjkResult result;
  NearestFeature nearest = nearest_of_simplex(difference, usable(difference, hint));
  Progress progress(nearest.squared);
  for (;;) {
    result.simplex = nearest.feature;
    result.direction = nearest.direction;
    if (nearest.holds_origin) break;
    ++result.iterations;
    const SupportPair support = difference.support(nearest.direction);
    const double height = nearest.direction.dot(difference.vertex(support));
    if (height > 0 && height * height > limit * limit * nearest.direction.dot(nearest.direction)) {
      result.apartness = Apartness::separated;
      return result;
    }
    const Vector2<double> gain = difference.edge(nearest.feature.vertices[0], support);
    if (nearest.direction.dot(gain) >= 0) return result;
    Simplex next = nearest.feature;
    next.vertices[next.count++] = support;
    nearest = nearest_of_simplex(difference, next);
    if (nearest.holds_origin) continue;
    const Vector2<double> far = difference.vertex(nearest.feature.vertices[0]);
    if (progress.goes_on(nearest.squared, far, support)) continue;
    if (height > 0) return result;
    result.simplex = next;
    break;
  }
  result.apartness = Apartness::overlapping;
  return result;
}

/// Whether a simplex is a face of a core, with a vertex of the other: canonical, so that its
/// direction is the face's normal from A to B.
template <class Scalar>
bool is_face(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
             const Simplex& simplex) {
  const auto& [p, q, unused] = simplex.vertices;
  if (simplex.count != 2) return false;
  return p.b == q.b ? q.a == a.next(p.a) : p.a == q.a && q.b == b.next(p.b);
}

/// The largest of a core's heights along a direction.
template <class Scalar>
Scalar greatest_height(const ConvexPolygon<Scalar>& core, const Vector2<Scalar>& direction) {
  Scalar greatest = direction.dot(core.vertices[0]);
  for (int i = 1; i < core.count; ++i) {
    const Scalar height = direction.dot(core.vertices[i]);
    greatest = height > greatest ? height : greatest;
  }
  return greatest;
}

/// Whether cores are still apart along the direction that the last step left, by more than `limit`,
/// a length >= 0: one support, and at most two of B's vertices placed, where gjk has to place all.
/// B stands at `b_in_a`. The height is off by at most 9 u times the extent, which is less than a
/// separation may be: 2.4 u of B's reach for the relative rotation, as much for the direction that
/// is turned back, 2 u for each of three products with their sums, 3.4 u of the distance for the
/// relative position, and 2 u for the sum of all. Overflowing, it is no number and separates
/// nothing.
template <class Scalar>
bool separates(const Simplex& hint, const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
               const Pose<Scalar>& b_in_a, Scalar limit) {
  const auto& [p, q, unused] = hint.vertices;
  if (hint.count < 1 || hint.count > 2 || p.a >= a.count || p.b >= b.count || q.a >= a.count ||
      q.b >= b.count) {
    return false;
  }
  Vector2<Scalar> direction;
  if (hint.count == 1) {
    direction = transform(b_in_a, b.vertices[p.b]) - a.vertices[p.a];
  } else {
    const Vector2<Scalar> of_b = b.vertices[q.b] - b.vertices[p.b];
    const Vector2<Scalar> of_a = a.vertices[q.a] - a.vertices[p.a];
    direction = counter_clockwise_quarter<Scalar>(rotate(b_in_a.rotation, of_b) - of_a);
  }
  const Vector2<Scalar> in_b = rotate_back(b_in_a.rotation, direction);
  const Scalar height = direction.dot(b_in_a.position) - greatest_height(a, direction) -
                        greatest_height<Scalar>(b, -in_b);
  const auto squared = [](double x) { return x * x; };  // of floats it neither over- nor underflows
  return height > 0 && squared(height) > squared(limit) * clipping::squared_length(direction);
}

}  // namespace manifuzz::methods
