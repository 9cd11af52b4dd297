#pragma once

#include <array>

#include "geometry/pair_case.hpp"

// Where the polygons stand, in double: for pictures, and as the filter of exact decisions.

namespace manifuzz::exact {

/// A polygon in world directions, seen from A's position; unit outward normals.
struct RoughPolygon {
  std::array<Vector2<double>, kMaxVertices> vertices;
  std::array<Vector2<double>, kMaxVertices> normals;
  int count = 0;

  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
};

struct RoughPair {
  RoughPolygon a;
  RoughPolygon b;

  const RoughPolygon& operator[](Side side) const { return side == Side::a ? a : b; }
};

RoughPair place_roughly(const PairCase& pair);

/// The separation of every face of both polygons, within one proven error.
struct Separations {
  std::array<std::array<double, kMaxVertices>, 2> of_face;
  std::array<double, 2> greatest;  ///< per side
  double error = 0;                ///< of each of them, a world length
};

/// `extent` is that of the pair.
Separations separations(const RoughPair& placed, double extent);

/// How far the dot of two of the unit normals may be off.
inline constexpr double kErrorOfDot = 0x1p-48;

}  // namespace manifuzz::exact
