#include <algorithm>
#include <limits>
#include <utility>

#include "generating/drafts.hpp"
#include "geometry/lanes.hpp"

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

/// The polygon's vertices turned as in the world, about its own origin.
Outline standing(const Body& body) {
  const Vector2<double> rotation = body.pose.rotation.cast<double>();
  Outline outline;
  outline.count = body.polygon.count;
  for (int i = 0; i < outline.count; ++i) {
    outline.vertices[i] = rotate<double>(rotation, body.polygon.vertices[i].cast<double>());
  }
  return outline;
}

/// Appends the faces of one polygon; `sign` is -1 for B's, whose outward is towards A. All faces at
/// once meet each vertex of the other.
void append_faces(Faces& faces, const Outline& from, const Outline& to, double sign) {
  LaneArray x{};
  LaneArray y{};
  for (int i = 0; i < from.count; ++i) {
    const Vector2<double> normal = clockwise_quarter(unit(from.face(i)));
    x[i] = normal.x();
    y[i] = normal.y();
  }
  const Lanes normals_x(x);
  const Lanes normals_y(y);
  Lanes least(std::numeric_limits<double>::infinity());
  for (int j = 0; j < to.count; ++j) {
    const Vector2<double>& vertex = to.vertices[j];
    least = min(least, normals_x * Lanes(vertex.x()) + normals_y * Lanes(vertex.y()));
  }
  const LaneArray nearest = least.array();
  for (int i = 0; i < from.count; ++i) {
    const Vector2<double> normal{x[i], y[i]};
    faces.normals[faces.count] = sign * normal;
    faces.offsets[faces.count] = normal.dot(from.vertices[i]) - nearest[i];
    ++faces.count;
  }
}

/// Makes a body of the sketch; false where rounding spoils its polygon or its rotation.
bool embody(const Sketch& sketch, float radius, const Pose<double>& world, Body& body) {
  const auto polygon = rounded(sketch.outline, radius, sketch.rounding);
  if (!polygon) return false;
  body.polygon = *polygon;
  body.pose.rotation = rotate(world.rotation, sketch.pose.rotation).cast<float>();
  body.pose.position = transform(world, sketch.pose.position).cast<float>();
  return is_unit_rotation(body.pose.rotation);
}

/// Puts B where the draft has it; false where its vertices cannot take up what is left.
bool place_b(const Draft& draft, PairCase& pair) {
  const Vector2<double> origin =
      transform(draft.world, Vector2<double>(draft.b.pose.position + draft.start));
  Vector2<double> place = origin - pair.a.pose.position.cast<double>();
  if (draft.gap) {
    place = slide(faces_of(pair), place, rotate(draft.world.rotation, draft.direction),
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

Faces faces_of(const PairCase& pair) {
  const Outline a = standing(pair.a);
  const Outline b = standing(pair.b);
  Faces faces;
  faces.count_a = a.count;
  append_faces(faces, a, b, 1);
  append_faces(faces, b, a, -1);
  return faces;
}

double separation(const Faces& faces, const Vector2<double>& p) {
  double greatest = faces.separation(0, p);
  for (int k = 1; k < faces.count; ++k) greatest = std::max(greatest, faces.separation(k, p));
  return greatest;
}

Vector2<double> slide(const Faces& faces, const Vector2<double>& start,
                      const Vector2<double>& direction, double target) {
  constexpr double parallel = 1e-12;
  double first = -std::numeric_limits<double>::infinity();
  double last = std::numeric_limits<double>::infinity();
  bool blocked = false;
  for (int k = 0; k < faces.count; ++k) {
    const double speed = faces.normals[k].dot(direction);
    const double room = target - faces.separation(k, start);
    const double until = room / speed;
    last = speed > parallel ? std::min(last, until) : last;
    first = speed < -parallel ? std::max(first, until) : first;
    blocked |= std::abs(speed) <= parallel && room < 0;
  }
  if (blocked || first > last) return start;
  return start + last * direction;
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
  std::array<Vector2<float>, kMaxVertices> vertices;
  for (int i = 0; i < outline.count; ++i) vertices[i] = outline.vertices[i].cast<float>();
  const std::span<const Vector2<float>> used(vertices.data(), outline.count);
  if (find_shape_defect(used, radius)) return std::nullopt;
  return make_polygon(used, radius, rounding);
}

void put_off_unit(Sketch& sketch, double defect) {
  sketch.pose.rotation *= std::sqrt(1 + defect);
}

std::optional<PairCase> settle(const Draft& draft) {
  std::optional<PairCase> pair(std::in_place);
  if (!embody(draft.a, draft.radius_a, draft.world, pair->a) ||
      !embody(draft.b, draft.radius_b, draft.world, pair->b) || !place_b(draft, *pair)) {
    pair.reset();
  }
  return pair;
}

}  // namespace manifuzz
