#pragma once

#include <array>

#include "geometry/manifold.hpp"

// What the floats of a case mean, to well past double: separations, angles and clips as numbers.
// What is admissible within which bound is decided in judging/; an exact arithmetic can stand in
// here.

namespace manifuzz::truth {

/// 64 bits of significand on x86: 2^11 times finer than the finest collider's roundoff.
using Real = long double;
using Vector = Vector2<Real>;

/// A polygon in world directions, seen from A's position; unit outward normals.
template <class Number>
struct WorldPolygon {
  std::array<Vector2<Number>, kMaxVertices> vertices;
  std::array<Vector2<Number>, kMaxVertices> normals;
  int count = 0;

  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
};

/// Both polygons where the stored floats put them: R v + p with R the matrix of (cos, sin) as it
/// is.
template <class Number>
struct World {
  WorldPolygon<Number> a;
  WorldPolygon<Number> b;
  Number total_radius = 0;

  const WorldPolygon<Number>& operator[](Side side) const { return side == Side::a ? a : b; }
};

template <class Number>
World<Number> place(const PairCase& pair);

/// For each face of `side`, the signed distance (world length) to the other's deepest vertex.
template <class Number>
std::array<Number, kMaxVertices> face_separations(const World<Number>& world, Side side);

/// For each edge of the other polygon, its normal's dot with the normal of face `face` of `side`.
std::array<Real, kMaxVertices> normal_dots(const World<Real>& world, Side side, int face);

/// S: the greatest face separation of both polygons, in double.
double separation(const PairCase& pair);

/// An end of the incident edge inside the slab, before the face decides whether it is kept.
struct ClipPoint {
  Vector position;  ///< in A's frame
  Real depth = 0;   ///< total radius - separation; negative in front of the face
  FeaturePair features;
  bool crossing = false;
  Real margin = 0;  ///< distance along the face from the unclipped end to the nearest side plane
};

/// The clip of one incident edge by one reference face.
struct Clip {
  Vector normal;         ///< unit, A to B, in A's frame
  Real cosine = 0;       ///< of the angle between incident edge and reference face, >= 0
  Real edge_length = 0;  ///< of the incident edge
  Real slab_width = 0;   ///< between the side planes
  Real gap = 0;          ///< by how much the edge misses the slab; negative: how far it reaches in
  int count = 0;         ///< 2, or 1 where the edge misses: then its nearest end, unclipped
  std::array<ClipPoint, 2> points;  ///< along the reference face's direction
};

Clip clip(const PairCase& pair, const World<Real>& world, Side reference_side, int reference,
          int incident);

}  // namespace manifuzz::truth
