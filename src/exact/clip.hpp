#pragma once

#include <array>
#include <span>

#include "exact/placed.hpp"
#include "exact/root_sum.hpp"
#include "geometry/manifold.hpp"

namespace manifuzz::exact {

/// Where an end of the incident edge lies along the reference face.
enum class Cut { before, inside, beyond };

/// A contact point's true place, in a number type.
template <class Number>
struct Located {
  Point<Element<Number>> position;  ///< in A's frame
  Element<Number> depth;            ///< total radius - separation, a world length
};

/// An end of the incident edge inside the slab, before the face decides whether it is kept.
struct ClipPoint {
  int end = 0;  ///< 0 or 1, along the reference face
  bool crossing = false;
  FeaturePair features;
  Located<Approximate<double>> located;

  Vector2<double> position() const { return {located.position.x.value, located.position.y.value}; }
  double depth() const { return located.depth.value; }
};

/// The clip of one incident edge by one reference face, the slab widened by the total radius as in
/// Box2D. Values are doubles; which end is cut is exact.
struct Clip {
  const StoredPair* pair = nullptr;  ///< whose polygons these are
  FaceOf reference;
  int incident = 0;
  std::array<Cut, 2> cuts{};
  Vector2<double> normal{0, 0};  ///< unit, A to B, in A's frame
  double cosine = 0;             ///< of the angle between incident edge and reference face, >= 0
  double tangent = 0;            ///< of the same, >= 0; its own, for 1 - cos^2 loses small angles
  double edge_length = 0;        ///< of the incident edge
  std::array<Approximate<double>, 2> along;  ///< of each end, from the first side plane inwards
  Approximate<double> width;                 ///< between the side planes
  int count = 0;  ///< 2, or 1 where the edge misses: then its nearest end, unclipped
  std::array<ClipPoint, 2> points;  ///< along the reference face's direction

  /// Whether the incident edge lies outside one of the side planes.
  bool misses() const { return cuts[0] == cuts[1] && cuts[0] != Cut::inside; }
  /// By how much the edge misses the slab; negative: how far it reaches in.
  double gap() const;
  /// The incident vertex at an end of the edge.
  int vertex(int end) const;
};

/// Its `count` points.
inline std::span<const ClipPoint> points_of(const Clip& clip) {
  return {clip.points.data(), static_cast<std::size_t>(clip.count)};
}

/// The clip refers to the pair, which must outlive it.
Clip clip(const StoredPair& pair, FaceOf reference, int incident);

/// The clip as a manifold, its figures right to the last digit of double: the ends that lie behind
/// the face; of an edge that misses the slab by more than `slack`, none.
Manifold<double> true_manifold(const Clip& clip, double slack = 0);

// Exact comparisons of what the clip is made of; each gives the sign of the difference.

/// Gap - length.
int compare_gap(const Clip& clip, double length);
/// Width of the slab - length.
int compare_width(const Clip& clip, double length);
/// Distance, along the face, from an unclipped end to the nearest side plane - length.
int compare_margin(const Clip& clip, int end, double length);

/// Depth of a point - length.
int compare_depth(const Clip& clip, const ClipPoint& point, double length);
/// Whether a reported figure lies no farther than `bound` from the true one; never where it is not
/// finite.
bool is_near_position(const Clip& clip, const ClipPoint& point, const Vector2<double>& position,
                      double bound);
bool is_near_depth(const Clip& clip, const ClipPoint& point, double depth, double bound);
bool is_near_normal(const Clip& clip, const Vector2<double>& normal, double bound);
/// The distance between both points - length.
int compare_apart(const Clip& clip, double length);

// The true figures of a clip in any number type: to well past double in pairs of doubles, exactly
// in rationals.

/// An end of the incident edge, in the world, from A's position.
template <class Number>
Point<Number> end_of(const Clip& clip, int end) {
  return vertex<Number>(*clip.pair, other(clip.reference.side), clip.vertex(end));
}

/// The square of the reference face's length.
template <class Number>
Number squared_face(const Clip& clip) {
  return square<Number>(*clip.pair, clip.reference);
}

template <class Number>
Number radius_of(const Clip& clip) {
  return total_radius<Number>(*clip.pair);
}

/// From the reference face's first corner to an end of the incident edge, along the face and times
/// its length.
template <class Number>
Number scaled_along(const Clip& clip, int end) {
  const FaceOf& face = clip.reference;
  const Point<Number> corner = vertex<Number>(*clip.pair, face.side, face.index);
  return dot(direction<Number>(*clip.pair, face), end_of<Number>(clip, end) - corner);
}

/// Where the line of the incident edge is after the clip, from A's position, in the world.
template <class Number>
Point<Element<Number>> world_position(const Clip& clip, int end, const Number& face) {
  using E = Element<Number>;
  const auto element = [&](const Number& number) { return with_root(number, Number(0.0), face); };
  if (clip.cuts[end] == Cut::inside || clip.misses()) {
    const Point<Number> at = end_of<Number>(clip, end);
    return {element(at.x), element(at.y)};
  }
  // The share of the edge at which it crosses the side plane: before 0, or beyond face + 2 r.
  const bool before = clip.cuts[end] == Cut::before;
  const Number radius = radius_of<Number>(clip);
  const Number first = scaled_along<Number>(clip, 0);
  const Number whole = scaled_along<Number>(clip, 1) - first;
  const E share = with_root(((before ? Number(0.0) : face) - first) / whole,
                            (before ? -radius : radius) / whole, face);
  const Point<Number> from = end_of<Number>(clip, 0);
  const Point<Number> edge = end_of<Number>(clip, 1) - from;
  return {element(from.x) + share * element(edge.x), element(from.y) + share * element(edge.y)};
}

/// The place of a clip point, by its end of the incident edge.
template <class Number>
Located<Number> locate(const Clip& clip, int end) {
  using E = Element<Number>;
  const Number face = squared_face<Number>(clip);
  const auto element = [&](const Number& number) { return with_root(number, Number(0.0), face); };
  const Point<E> world = world_position<Number>(clip, end, face);
  const StoredPair& pair = *clip.pair;
  const Point<Number> corner = vertex<Number>(pair, clip.reference.side, clip.reference.index);
  const Point<Number> out = outward<Number>(pair, clip.reference);
  const E scaled = element(out.x) * (world.x - element(corner.x)) +
                   element(out.y) * (world.y - element(corner.y));
  const E depth =
      element(radius_of<Number>(clip)) - scaled * with_root(Number(0.0), Number(1.0) / face, face);
  const Point<Number> r = widen<Number>(pair.a.pose.rotation);
  const Number scale_a = scale<Number>(pair.a);
  const E cosine = element(r.x / scale_a);
  const E sine = element(r.y / scale_a);
  return {{cosine * world.x + sine * world.y, cosine * world.y - sine * world.x}, depth};
}

/// A face's unit normal from A to B, in A's frame.
template <class Number, class AnyPair>
Point<Element<Number>> true_normal(const AnyPair& pair, FaceOf face) {
  const Point<Number> local = turned_back(pair.a, outward_from_a<Number>(pair, face));
  const Number length_squared = dot(local, local);
  return {with_root(Number(0.0), local.x / length_squared, length_squared),
          with_root(Number(0.0), local.y / length_squared, length_squared)};
}

/// The reference face's.
template <class Number>
Point<Element<Number>> true_normal(const Clip& clip) {
  return true_normal<Number>(*clip.pair, clip.reference);
}

}  // namespace manifuzz::exact
