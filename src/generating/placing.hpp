#pragma once

#include <array>
#include <functional>
#include <optional>

#include "generating/shapes.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// One polygon of a drawing: its outline, and where the outline's own frame stands in the drawing.
struct Sketch {
  Outline outline;
  Pose<double> pose;
};

/// Two polygons drawn in one frame, and how they are to meet: B is moved by `start`, and from there
/// along `direction` until the separation is the total radius plus `gap`.
struct Draft {
  Sketch a;
  Sketch b;
  Vector2<double> start{0, 0};
  Vector2<double> direction{0, 1};
  std::optional<double> gap;  ///< a length; none: B stays where it starts
  float radius_a = 0;
  float radius_b = 0;
  Pose<double> world;  ///< where the drawing stands in the world
  /// B's vertices, in place of its position, take up what rounding the position leaves.
  bool exact_gap = false;
};

/// The same meeting with A and B exchanged.
Draft swapped(const Draft& draft);

/// The faces of both polygons as half planes of B's place: with B's origin at p from A's, both
/// turned as in the world, face k separates by normals[k] . p - offsets[k]. A's faces come first.
struct Faces {
  static constexpr std::size_t kMost = 2UL * kMaxVertices;
  std::array<Vector2<double>, kMost> normals;
  std::array<double, kMost> offsets;
  int count = 0;
  int count_a = 0;

  Side side(int face) const { return face < count_a ? Side::a : Side::b; }
  double separation(int face, const Vector2<double>& p) const {
    return normals[face].dot(p) - offsets[face];
  }
};

/// Of the stored floats, in double. The positions do not matter.
Faces faces_of(const PairCase& pair);

/// The greatest separation with B at p from A.
double separation(const Faces& faces, const Vector2<double>& p);

/// The last place on the way from `start` along `direction` with separation `target`; `start`
/// itself where there is none.
Vector2<double> slide(const Faces& faces, const Vector2<double>& start,
                      const Vector2<double>& direction, double target);

/// B's origin from A's, of the stored floats.
Vector2<double> apart(const PairCase& pair);

/// Sets B's position to p from A's, rounded.
void put_apart(PairCase& pair, const Vector2<double>& p);

/// Moves B by `residual` (world) through its vertices; false where floats leave no valid polygon.
bool shift_vertices(Body& body, const Vector2<double>& residual);

/// Puts both origins next to the world's, where floats are dense, and B at `place`, from A's
/// origin, to a small share of an ulp: its vertices take up nearly all of the way. False where
/// floats leave no valid polygon.
bool place_exactly(PairCase& pair, const std::function<Vector2<double>(const Faces&)>& place);

/// The outline rounded to floats, or none where that leaves no valid polygon.
std::optional<ConvexPolygon<float>> rounded(const Outline& outline, float radius);

/// Gives the rotation cos^2 + sin^2 = 1 + `defect`.
void put_off_unit(Sketch& sketch, double defect);

/// The drawing as a pair case, B placed by the rounded polygons; none where rounding spoils a
/// polygon or a rotation.
std::optional<PairCase> settle(const Draft& draft);

/// A rotation by an angle of tangent 2 t / (1 - t^2).
inline Vector2<double> turn_by(double t) {
  return Vector2<double>(1 - t * t, 2 * t) / (1 + t * t);
}

}  // namespace manifuzz
