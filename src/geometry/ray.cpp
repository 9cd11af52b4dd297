#include "geometry/ray.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {
namespace {

/// A shape's core seen from where a ray begins, and the ray.
struct Seen {
  std::array<Vector2<double>, kMaxVertices> vertices;
  std::array<Vector2<double>, kMaxVertices> normals;  ///< of each face, unit, outward
  Vector2<double> along;
  double radius;
  int count;

  Vector2<double> face(int i) const { return vertices[i + 1 < count ? i + 1 : 0] - vertices[i]; }
};

Seen seen_from(const Ray& ray, const ConvexPolygon<float>& shape, const Pose<float>& pose) {
  Seen seen{{}, {}, ray.along.cast<double>(), static_cast<double>(shape.radius), shape.count};
  const Vector2<double> rotation = pose.rotation.cast<double>();
  const Vector2<double> position = pose.position.cast<double>() - ray.from.cast<double>();
  for (int i = 0; i < shape.count; ++i) {
    seen.vertices[i] = rotate<double>(rotation, shape.vertices[i].cast<double>()) + position;
  }
  for (int i = 0; i < shape.face_count(); ++i) {
    const Vector2<double> face = rotate<double>(
        rotation,
        (shape.vertices[shape.next(i)].cast<double>() - shape.vertices[i].cast<double>()));
    seen.normals[i] = clockwise_quarter(unit_direction(face));
  }
  return seen;
}

/// How far the ray's beginning lies before a face that is moved out by the radius; a length.
double before_face(const Seen& seen, int i) {
  return -seen.normals[i].dot(seen.vertices[i]) - seen.radius;
}

void take(std::optional<RayHit>& first, const RayHit& hit) {
  if (!(hit.share >= 0 && hit.share <= 1)) return;
  if (!first || hit.share < first->share) first = hit;
}

/// A polygon without a radius: the way lies in it from where it enters the last half-plane, if it
/// leaves none before.
std::optional<RayHit> meet_half_planes(const Seen& seen) {
  RayHit enters{-1, {0, 0}};
  double leaves = 1;
  for (int i = 0; i < seen.count; ++i) {
    const double before = before_face(seen, i);
    const double speed = seen.normals[i].dot(seen.along);
    if (before > 0 && speed >= 0) return std::nullopt;
    const double share = -before / speed;
    if (before > 0 && share > enters.share) enters = {share, seen.normals[i]};
    if (speed > 0) leaves = std::min(leaves, share);
  }
  if (enters.share > leaves) return std::nullopt;
  return RayHit{std::max(enters.share, 0.0), enters.normal};
}

/// Whether the ray begins no farther from the core than the radius.
bool begins_inside(const Seen& seen, int faces) {
  bool is_behind_all = faces >= kMinVertices;
  for (int i = 0; i < faces; ++i) {
    const Vector2<double> face = seen.face(i);
    const double before = -seen.normals[i].dot(seen.vertices[i]);
    const double past = -face.dot(seen.vertices[i]);
    is_behind_all = is_behind_all && before <= 0;
    if (before >= 0 && before <= seen.radius && past >= 0 && past <= face.dot(face)) return true;
  }
  const auto is_in_disc = [&](const Vector2<double>& centre) {
    return centre.dot(centre) <= seen.radius * seen.radius;
  };
  return is_behind_all ||
         std::any_of(seen.vertices.begin(), seen.vertices.begin() + seen.count, is_in_disc);
}

/// A disc around a vertex.
void meet_disc(const Seen& seen, const Vector2<double>& centre, std::optional<RayHit>& first) {
  const double length = std::sqrt(seen.along.dot(seen.along));
  if (length == 0) return;
  const Vector2<double> direction = seen.along / length;
  const double beside = cross<double>(direction, centre);
  if (std::abs(beside) > seen.radius) return;
  const double chord = std::sqrt((seen.radius - beside) * (seen.radius + beside));
  const double way = direction.dot(centre) - chord;
  const Vector2<double> from_centre = beside * clockwise_quarter(direction) - chord * direction;
  const bool is_point = from_centre.x() == 0 && from_centre.y() == 0;
  take(first, {way / length, unit_direction(is_point ? Vector2<double>(-direction) : from_centre)});
}

/// A shape with a radius is what its moved faces bound between their ends, and a disc around each
/// vertex.
std::optional<RayHit> meet_round(const Seen& seen, int faces) {
  if (begins_inside(seen, faces)) return RayHit{};
  std::optional<RayHit> first;
  for (int i = 0; i < faces; ++i) {
    const double before = before_face(seen, i);
    const double speed = seen.normals[i].dot(seen.along);
    if (!(before > 0 && speed < 0)) continue;
    const double share = before / -speed;
    const Vector2<double> face = seen.face(i);
    const double past = face.dot(Vector2<double>(share * seen.along - seen.vertices[i]));
    if (past >= 0 && past <= face.dot(face)) take(first, {share, seen.normals[i]});
  }
  for (int i = 0; i < seen.count; ++i) meet_disc(seen, seen.vertices[i], first);
  return first;
}

}  // namespace

std::optional<RayHit> cast_ray(const ConvexPolygon<float>& shape, const Pose<float>& pose,
                               const Ray& ray) {
  const Seen seen = seen_from(ray, shape, pose);
  const bool is_sharp = !shape.is_round() && shape.radius == 0;
  return is_sharp ? meet_half_planes(seen) : meet_round(seen, shape.face_count());
}

}  // namespace manifuzz
