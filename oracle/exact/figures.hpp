#pragma once

#include "oracle/exact/clip.hpp"

// The true figures of a clip in any number type: to well past double in pairs of doubles, exactly
// in rationals.

namespace manifuzz::exact {

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
  const PairCase& pair = *clip.pair;
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
template <class Number>
Point<Element<Number>> true_normal(const PairCase& pair, FaceOf face) {
  const Point<Number> out = outward<Number>(pair, face);
  const Point<Number> local =
      turned_back(pair.a, face.side == Side::a ? out : Point<Number>{-out.x, -out.y});
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
