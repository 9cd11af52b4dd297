#pragma once

#include <span>

#include "generating/outline.hpp"
#include "geometry/lanes.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

// What is done with all of a polygon's corners, or faces, at once.

/// Computes the normals of a polygon. False where it is not plain, by more than rounding, that it
/// is free of defects and what its normals are; then they are anything.
bool set_plain_normals(ConvexPolygon<float>& polygon);

/// Rounds outlines to the vertices of a pair's polygons, whose counts are set, and computes their
/// normals. False where those of one are not plain.
bool round_plainly(const Outline& a, const Outline& b, PairCase& pair);

/// The faces of one polygon as half planes of B's place: with B's origin at p from A's, both turned
/// as in the world, face i separates by its normal . p - its offset. Lanes behind the last face
/// never separate.
struct FacesOf {
  int count = 0;
  LaneArray normals_x;
  LaneArray normals_y;
  LaneArray offsets;
};

/// The faces of both polygons, A's counted first.
struct Faces {
  FacesOf a;
  FacesOf b;

  int count() const { return a.count + b.count; }
  Side side(int face) const { return face < a.count ? Side::a : Side::b; }
  Vector2<double> normal(int face) const {
    return {lane(&FacesOf::normals_x, face), lane(&FacesOf::normals_y, face)};
  }
  double offset(int face) const { return lane(&FacesOf::offsets, face); }
  double separation(int face, const Vector2<double>& p) const {
    return normal(face).dot(p) - offset(face);
  }

 private:
  double lane(LaneArray FacesOf::*lanes, int face) const {
    return face < a.count ? (a.*lanes)[face] : (b.*lanes)[face - a.count];
  }
};

/// The faces of the stored floats, in double. The positions do not matter.
Faces faces_of(const PairCase& pair);

/// The last place on the way from `start` along `direction` with separation `target`; `start`
/// itself where there is none.
Vector2<double> slide(const Faces& faces, const Vector2<double>& start,
                      const Vector2<double>& direction, double target);
/// Slides along the faces of a pair, from `start` until the separation is `target`.
Vector2<double> slide(const PairCase& pair, const Vector2<double>& start,
                      const Vector2<double>& direction, double target);

}  // namespace manifuzz
