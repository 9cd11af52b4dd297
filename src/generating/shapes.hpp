#pragma once

#include <array>
#include <cmath>

#include "base/random.hpp"
#include "geometry/convex_polygon.hpp"

namespace manifuzz {

/// A convex polygon on the drawing board: counter-clockwise, in doubles, not yet rounded to floats.
/// Face i runs from vertex i to vertex i + 1.
struct Outline {
  std::array<Vector2<double>, kMaxVertices> vertices;
  int count = 0;

  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : count - 1; }
  Vector2<double> face(int i) const { return vertices[next(i)] - vertices[i]; }
};

inline double length(const Vector2<double>& v) {
  return std::sqrt(v.dot(v));
}

/// `v` made of unit length.
inline Vector2<double> unit(const Vector2<double>& v) {
  return v / length(v);
}

/// A rational point of the unit circle, (1 - t^2, 2t) / (1 + t^2) in a random quadrant: a
/// direction, or a rotation as (cos, sin). All the way round, not quite evenly.
Vector2<double> random_direction(Random& random);

/// Triangles to octagons, equally often up to `most`.
int random_count(Random& random, int most = kMaxVertices);

/// Corners on a circle of radius 1, at random angles.
Outline inscribed(Random& random, int count);

/// A triangle or quadrilateral with its corners cut until there are `count`: edges of all lengths.
Outline carved(Random& random, int count);

/// Inscribed or carved, flattened somewhat and turned; about 2 across.
Outline random_outline(Random& random, int count);
Outline random_outline(Random& random);

Outline box(double half_width, double half_height);

/// Corners on the unit circle, the first at (0, 1): mirror-symmetric to the y axis, exactly.
Outline regular_outline(int count);

/// The mean of the vertices: inside.
Vector2<double> middle(const Outline& outline);

/// The longer side of the bounding box: between the diameter over sqrt 2 and the diameter.
double span(const Outline& outline);

Outline stretched(const Outline& outline, double x, double y);
Outline turned(const Outline& outline, const Vector2<double>& rotation);
Outline moved(const Outline& outline, const Vector2<double>& by);

/// Turned so that the face lies on y = 0, facing +y, with the origin at `share` of its length.
Outline face_up(const Outline& outline, int face, double share);

/// Turned so that the corner lies at the origin and +y within its two normals, `lean` of the way
/// from the normal of the face before (0) to the normal of the face after (1).
Outline corner_up(const Outline& outline, int corner, double lean);

/// Turned by half a turn, exactly: what was up is down.
Outline upside_down(const Outline& outline);

/// The corner replaced by a face (numbered as the corner was), from the share `before` of the face
/// before it to the share `after` of the face after it. Needs room for one more vertex.
Outline chamfered(const Outline& outline, int corner, double before, double after);

/// The same by lengths along both faces, each cut to less than half of its face.
Outline cut_corner(const Outline& outline, int corner, double before, double after);

/// The vertex inserted into the face, between its ends. Needs room for one more.
Outline with_vertex(const Outline& outline, int face, const Vector2<double>& vertex);

}  // namespace manifuzz
