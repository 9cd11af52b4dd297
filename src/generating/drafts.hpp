#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "generating/in_lanes.hpp"
#include "generating/outline.hpp"
#include "generating/regime.hpp"
#include "geometry/convex_polygon.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

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

/// Corners on a circle, or cut off a triangle or quadrilateral; flattened somewhat and turned;
/// about 2 across.
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
void scale(Outline& outline, double by);
Outline turned(const Outline& outline, const Vector2<double>& rotation);
Outline moved(const Outline& outline, const Vector2<double>& by);

/// Gives the outline another frame, which stands in the old one as `inner`; nothing moves.
void reframe(Outline& outline, const Pose<double>& inner);

/// Turned so that the face lies on y = 0, facing +y, with the origin at `share` of its length.
Outline face_up(const Outline& outline, int face, double share);

/// Turned so that the corner lies at the origin and +y within its two normals, `lean` of the way
/// from the normal of the face before (0) to the normal of the face after (1).
Outline corner_up(const Outline& outline, int corner, double lean);

/// Turned by half a turn, exactly: what was up is down.
Outline upside_down(const Outline& outline);

/// The corner replaced by a face (numbered as the corner was), from the share `before` of the face
/// before it to the share `after` of the face after it. Needs room for one more vertex.
Outline chamfered(Outline outline, int corner, double before, double after);

/// The corner cut by lengths along both faces, each cut to less than half of its face.
Outline cut_corner(const Outline& outline, int corner, double before, double after);

/// The vertex inserted into the face, between its ends. Needs room for one more.
Outline with_vertex(Outline outline, int face, const Vector2<double>& vertex);

/// One polygon of a drawing: its outline, and where the outline's own frame stands in the drawing.
struct Sketch {
  Outline outline;
  Pose<double> pose{};
  Rounding rounding = Rounding::mitre;
};

/// Two polygons drawn in one frame, and how they are to meet: B is moved by `start`, and from there
/// along `direction` until the separation is the total radius plus `gap`.
struct Draft {
  Sketch a;
  Sketch b;
  Vector2<double> start{0, 0};
  Vector2<double> direction{0, 1};
  std::optional<double> gap{};  ///< a length; none: B stays where it starts
  float radius_a = 0;
  float radius_b = 0;
  Pose<double> world{};  ///< where the drawing stands in the world
  /// B's vertices, in place of its position, take up what rounding the position leaves.
  bool exact_gap = false;
};

/// The meeting with A and B exchanged.
Draft swapped(const Draft& draft);

/// The greatest separation with B at p from A.
double separation(const Faces& faces, const Vector2<double>& p);

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

/// The outline in floats, or none where that leaves no valid shape.
std::optional<ConvexPolygon<float>> rounded(const Outline& outline, float radius,
                                            Rounding rounding = Rounding::mitre);

/// Gives the rotation cos^2 + sin^2 = 1 + `defect`.
void put_off_unit(Sketch& sketch, double defect);

/// Makes the drawing a pair case, B placed by the rounded polygons; false where rounding spoils a
/// polygon or a rotation.
bool settle(const Draft& draft, PairCase& pair);

/// A rotation by an angle of tangent 2 t / (1 - t^2).
inline Vector2<double> turn_by(double t) {
  return Vector2<double>(1 - t * t, 2 * t) / (1 + t * t);
}

// How two outlines meet. In all but `free_pair` the drawing has A below and B above, the contact
// near the origin and its normal along +y. The outlines keep the size they come with.

/// B in any turn, met from any side: each outline keeps its own axes.
void meet_freely(Random& random, Draft& draft);
Draft free_pair(Random& random, const Outline& a, const Outline& b);

/// Two facing faces that overlap, B's turned by `tilt`, the sine over the cosine of the angle.
Draft face_to_face(Random& random, const Outline& a, const Outline& b, double tilt);

/// A's face, pierced by a corner of B.
Draft corner_to_face(Random& random, const Outline& a, const Outline& b);

/// A corner of A under a corner of B.
Draft corner_to_corner(Random& random, const Outline& a, const Outline& b);

/// One of the four, A and B exchanged half the time.
Draft any_meeting(Random& random, const Outline& a, const Outline& b);

/// Any meeting of two outlines from `sized_outline`.
Draft any_meeting(Random& random);

/// A random outline of random count, between a quarter and twice the usual size.
Outline sized_outline(Random& random, int most = kMaxVertices);

/// The outline with a face on y = 0, facing +y, or with a corner up at the origin, but not within
/// `margin` (a share) of a face's ends, or of a corner's two normals.
Outline face_or_corner_up(Random& random, const Outline& outline, double margin);

/// The draft, or A and B exchanged.
Draft maybe_swapped(Random& random, const Draft& draft);

/// The smaller outline's span.
double span(const Draft& draft);

/// About half the time none; else Box2D's default (0.01 `unit`) or something small, mostly of both
/// alike. The context's radius comes before all.
void draw_radii(Random& random, const GenerationContext& context, Draft& draft, double unit = 1);

/// A gap as a share of the size: mostly touching, the rest near, as few as asked beyond that.
double draw_gap(Random& random, double beyond = 0);

/// Radii and gap, by the draft's size.
void aim(Random& random, const GenerationContext& context, Draft& draft, double unit = 1);

/// A multiple of a quarter turn.
Vector2<double> quarter_turn(Random& random);

/// Any rotation, and a position of up to ten sizes, often the origin.
Pose<double> random_world(Random& random, double size);

/// Moves the origin of each outline off its middle now and then, and stands the drawing anywhere.
void stand(Random& random, Draft& draft);

/// Either keeps the drawing's frame, at the world's origin, so that floats near the contact are
/// dense and the construction is exact; or gives each polygon a frame of its own and stands it
/// anywhere.
void frame(Random& random, Draft& draft, double exact = 0.5);

/// The numbers of a case that may be changed one at a time: all vertices, positions and radii.
std::vector<float*> free_numbers(PairCase& pair);

/// The shapes of a pair case that need no checking: their vertices are known to be valid, and their
/// normals to be those of the vertices.
struct KnownShapes {
  bool a = false;
  bool b = false;
};

/// The case with its normals computed afresh, or none where its vertices, poses or radii are not
/// valid. Shapes that are known to be are left as they stand.
std::optional<PairCase> revalidated(PairCase pair, KnownShapes is_known = {});

// Other ways to write a case that change no contact.

/// A quarter turn of the world.
void turn_by_quarter(PairCase& pair);

/// All lengths multiplied.
void scale_lengths(PairCase& pair, float factor);

/// Vertices and faces are counted from the second one on.
void renumber(ConvexPolygon<float>& polygon);

/// A face of A and one of B that can separate alike.
struct Tie {
  int face_a = 0;  ///< numbered as in `Faces`
  int face_b = 0;
  double separation = 0;  ///< of B's face there
};

/// Walks with B round A, at the separation that the pair has, until the face that separates changes
/// owner: clockwise where `sense` is 1, the other way where it is -1. None where there is no such
/// place.
std::optional<Tie> find_tie(const PairCase& pair, double sense);

/// B's place, from A, where B's face of the tie leads A's by `lead`.
Vector2<double> place_at(const Faces& faces, const Tie& tie, double lead);

}  // namespace manifuzz
