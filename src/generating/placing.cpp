#include <algorithm>
#include <limits>
#include <utility>

#include "generating/drafts.hpp"
#include "geometry/both.hpp"

namespace manifuzz {
namespace {

Outline outline_of(const Body& body) {
  Outline outline;
  outline.count = body.polygon.count;
  for (int i = 0; i < outline.count; ++i) {
    outline.vertices[i] = body.polygon.vertices[i].cast<double>();
  }
  return outline;
}

/// Makes a polygon of vertices that have been rounded; false where that has left no valid shape.
bool mend(ConvexPolygon<float>& polygon) {
  if (find_shape_defect(polygon.corners(), polygon.radius)) return false;
  polygon = make_polygon(polygon.corners(), polygon.radius, polygon.rounding);
  return true;
}

/// All of a polygon but its vertices and normals.
void outfit(const Outline& outline, float radius, Rounding rounding,
            ConvexPolygon<float>& polygon) {
  polygon.count = outline.count;
  polygon.radius = radius;
  polygon.rounding = outline.count < kMinVertices ? Rounding::round : rounding;
}

/// Makes a body of the sketch, but for vertices and normals.
void embody(const Sketch& sketch, float radius, const Pose<double>& world, Body& body) {
  outfit(sketch.outline, radius, sketch.rounding, body.polygon);
  body.pose.rotation = rotate(world.rotation, sketch.pose.rotation).cast<float>();
  body.pose.position = transform(world, sketch.pose.position).cast<float>();
}

/// Makes both bodies; false where rounding spoils a polygon or a rotation.
bool embody(const Draft& draft, PairCase& pair) {
  embody(draft.a, draft.radius_a, draft.world, pair.a);
  embody(draft.b, draft.radius_b, draft.world, pair.b);
  if (!round_plainly(draft.a.outline, draft.b.outline, pair) &&
      !(mend(pair.a.polygon) && mend(pair.b.polygon))) {
    return false;
  }
  return is_unit_rotation(pair.a.pose.rotation) && is_unit_rotation(pair.b.pose.rotation);
}

/// Puts B where the draft has it; false where its vertices cannot take up what is left.
bool place_b(const Draft& draft, PairCase& pair) {
  const Vector2<double> origin =
      transform(draft.world, Vector2<double>(draft.b.pose.position + draft.start));
  Vector2<double> place = origin - pair.a.pose.position.cast<double>();
  if (draft.gap) {
    place = slide(pair, place, rotate(draft.world.rotation, draft.direction),
                  total_radius(pair) + *draft.gap);
  }
  put_apart(pair, place);
  return !draft.exact_gap || shift_vertices(pair.b, place - apart(pair));
}

}  // namespace

Draft swapped(const Draft& draft) {
  Draft result = draft;
  std::swap(result.a, result.b);
  std::swap(result.radius_a, result.radius_b);
  result.start = -draft.start;
  result.direction = -draft.direction;
  return result;
}

double separation(const Faces& faces, const Vector2<double>& p) {
  double greatest = faces.separation(0, p);
  for (int k = 1; k < faces.count(); ++k) greatest = std::max(greatest, faces.separation(k, p));
  return greatest;
}

Vector2<double> apart(const PairCase& pair) {
  return pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>();
}

void put_apart(PairCase& pair, const Vector2<double>& p) {
  pair.b.pose.position = (pair.a.pose.position.cast<double>() + p).cast<float>();
}

bool shift_vertices(Body& body, const Vector2<double>& residual) {
  const Vector2<double> shift = rotate_inverse<double>(body.pose.rotation.cast<double>(), residual);
  const auto polygon =
      rounded(moved(outline_of(body), shift), body.polygon.radius, body.polygon.rounding);
  if (polygon) body.polygon = *polygon;
  return polygon.has_value();
}

bool place_exactly(PairCase& pair, const std::function<Vector2<double>(const Faces&)>& place) {
  pair.a.pose.position = pair.b.pose.position = {0, 0};
  if (!shift_vertices(pair.b, place(faces_of(pair)))) return false;
  put_apart(pair, place(faces_of(pair)));
  return true;
}

std::optional<ConvexPolygon<float>> rounded(const Outline& outline, float radius,
                                            Rounding rounding) {
  ConvexPolygon<float> polygon;
  outfit(outline, radius, rounding, polygon);
  for (int i = 0; i < outline.count; ++i) {
    store(floats(both(outline.vertices[i])), polygon.vertices[i]);
  }
  if (!set_plain_normals(polygon) && !mend(polygon)) return std::nullopt;
  return polygon;
}

void put_off_unit(Sketch& sketch, double defect) {
  sketch.pose.rotation *= std::sqrt(1 + defect);
}

bool settle(const Draft& draft, PairCase& pair) {
  return embody(draft, pair) && place_b(draft, pair);
}

}  // namespace manifuzz
