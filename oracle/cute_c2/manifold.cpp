#include "oracle/cute_c2/manifold.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace manifuzz::as_cute {
namespace {

using replayed::has;

using Segment = std::array<Vector2<float>, 2>;

/// c2h.
struct Plane {
  Vector2<float> normal{0, 0};
  float offset = 0;

  float distance(const Vector2<float>& p) const { return normal.dot(p) - offset; }
};

/// c2PlaneAt.
Plane plane_at(const Shape& polygon, std::size_t i) {
  return {polygon.normals[i], polygon.normals[i].dot(polygon.vertices[i])};
}

/// c2Clip: whether both ends are left.
bool is_clipped(Segment& segment, const Plane& plane, unsigned mended) {
  std::vector<Vector2<float>> left;
  const float first = plane.distance(segment[0]);
  const float second = plane.distance(segment[1]);
  if (first < 0) left.push_back(segment[0]);
  if (second < 0) left.push_back(segment[1]);
  if (has(mended, FaultOfCute::open_planes) && left.size() < 2 && (first == 0 || second == 0)) {
    const Vector2<float> on_plane = first == 0 ? segment[0] : segment[1];
    segment = {left.empty() ? on_plane : left[0], on_plane};
    return true;
  }
  if (first == 0 && second == 0) return true;
  if (first * second <= 0) {
    left.push_back(segment[0] + (segment[1] - segment[0]) * (first / (first - second)));
  }
  if (left.size() < 2) return false;
  segment = {left[0], left[1]};
  return true;
}

/// c2SidePlanes: the plane of the face, where the segment has two ends between its own.
std::optional<Plane> clip_by_sides(Segment& segment, const Vector2<float>& from,
                                   const Vector2<float>& to, unsigned mended,
                                   const Vector2<float>* own_normal = nullptr) {
  Vector2<float> along = unit_of(to - from);
  if (has(mended, FaultOfCute::placed_vertices) && own_normal != nullptr)
    along = counter_clockwise_quarter(*own_normal);
  const Plane left{-along, (-along).dot(from)};
  const Plane right{along, along.dot(to)};
  if (!is_clipped(segment, left, mended) || !is_clipped(segment, right, mended))
    return std::nullopt;
  const Vector2<float> out = clockwise_quarter(along);
  return Plane{out, out.dot(from)};
}

/// c2SidePlanesFromPoly.
std::optional<Plane> clip_by_face(Segment& segment, const Shape& polygon, std::size_t face,
                                  unsigned mended) {
  const Vector2<float> own = rotate(polygon.placing.rotation, polygon.normals[face]);
  return clip_by_sides(segment, polygon.vertex(face), polygon.vertex(polygon.next(face)), mended,
                       &own);
}

/// c2Incident.
Segment incident_edge(const Shape& polygon, const Vector2<float>& normal) {
  std::size_t most_against = 0;
  for (std::size_t i = 1; i < polygon.count(); ++i) {
    if (normal.dot(polygon.normals[i]) < normal.dot(polygon.normals[most_against])) {
      most_against = i;
    }
  }
  return {polygon.vertex(most_against), polygon.vertex(polygon.next(most_against))};
}

replayed::Contact::Point point_of(const Vector2<float>& at, float depth) {
  return {at.cast<double>(), static_cast<double>(depth)};
}

/// c2KeepDeep; `radius` is added to the depths, `flipped` turns the normal about.
CuteAnswer keep_deep(const Segment& segment, const Plane& plane, float radius, bool flipped) {
  CuteAnswer answer{.contact = {}, .way = Way::face};
  for (const Vector2<float>& p : segment) {
    const float d = plane.distance(p);
    if (d <= 0) answer.contact.points.push_back(point_of(p, -d + radius));
  }
  answer.contact.normal = (flipped ? -plane.normal : plane.normal).cast<double>();
  return answer;
}

/// One point, on a core or `out` along the normal from it.
CuteAnswer one_point(Way way, const Vector2<float>& normal, const Vector2<float>& on_core,
                     float out, float depth, float distance) {
  const Vector2<float> at = on_core + normal * out;
  return {{normal.cast<double>(), {point_of(at, depth)}},
          way,
          distance,
          on_core.cast<double>(),
          static_cast<double>(out)};
}

CuteAnswer apart_by(float distance) {
  return {.contact = {}, .distance = distance};
}

/// A face, and how far the other shape is from it.
struct BestFace {
  std::size_t index = 0;
  float separation = -std::numeric_limits<float>::max();
};

/// c2CircletoCircleManifold.
CuteAnswer of_circles(const Shape& a, const Shape& b) {
  const Vector2<float> d = b.vertices[0] - a.vertices[0];
  const float square = d.dot(d);
  const float r = a.radius + b.radius;
  if (!(square < r * r)) return {};
  const float length = std::sqrt(square);
  const Vector2<float> n = length != 0 ? Vector2<float>(d * (1.0F / length)) : Vector2<float>(0, 1);
  return one_point(length != 0 ? Way::nearest : Way::inside, n, b.vertices[0], -b.radius,
                   r - length, length);
}

/// c2CircletoCapsuleManifold, c2CapsuletoCapsuleManifold: `across` is whose core decides where they
/// are at no distance.
CuteAnswer of_capsules(const Shape& a, const Shape& b, const Shape& across) {
  const Nearest nearest = nearest_by_cute(a, b);
  const float r = a.radius + b.radius;
  if (!(nearest.distance < r)) return apart_by(nearest.distance);
  const bool is_inside = nearest.distance == 0;
  const Vector2<float> n =
      is_inside ? unit_of(counter_clockwise_quarter<float>(across.vertices[1] - across.vertices[0]))
                : unit_of(nearest.on_b - nearest.on_a);
  CuteAnswer answer = one_point(is_inside ? Way::inside : Way::nearest, n, nearest.on_b, -b.radius,
                                r - nearest.distance, nearest.distance);
  answer.is_within_epsilon = nearest.is_within_epsilon;
  return answer;
}

/// c2CircletoPolyManifold.
CuteAnswer of_circle_and_polygon(const Shape& circle, const Shape& polygon) {
  const Nearest nearest = nearest_by_cute(circle, polygon);
  if (nearest.distance != 0) {
    const Vector2<float> n = nearest.on_b - nearest.on_a;
    const float square = n.dot(n);
    if (!(square < circle.radius * circle.radius)) return apart_by(nearest.distance);
    const float length = std::sqrt(square);
    return {
        {(n * (1.0F / length)).cast<double>(), {point_of(nearest.on_b, circle.radius - length)}},
        Way::nearest,
        nearest.distance};
  }
  const Vector2<float> local = placed_back(polygon.placing, circle.vertices[0]);
  BestFace best;
  for (std::size_t i = 0; i < polygon.count(); ++i) {
    const float d = plane_at(polygon, i).distance(local);
    if (d > circle.radius) return {};
    if (d > best.separation) best = {i, d};
  }
  const Plane plane = plane_at(polygon, best.index);
  const Vector2<float> on_face = local - plane.normal * plane.distance(local);
  return one_point(Way::face, -rotate(polygon.placing.rotation, plane.normal),
                   transform(polygon.placing, on_face), 0, circle.radius - best.separation, 0);
}

/// A capsule's points as far from its core as it has radius; those on the polygon are on its
/// surface already.
void move_to_surface(replayed::Contact& contact, const Shape& capsule) {
  for (replayed::Contact::Point& point : contact.points) {
    point.at += static_cast<double>(capsule.radius) * contact.normal;
  }
}

/// One side of a capsule clips: case 1 and case 2 of c2CapsuletoPolyManifold.
CuteAnswer of_side(const Shape& capsule, const Shape& polygon, const Plane& side,
                   const Segment& core, const Segment& local_core, unsigned mended) {
  Segment incident = incident_edge(polygon, side.normal);
  const Segment& ends = has(mended, FaultOfCute::two_frames) ? core : local_core;
  const auto plane = clip_by_sides(incident, ends[0], ends[1], mended);
  return plane ? keep_deep(incident, *plane, capsule.radius, false) : CuteAnswer{};
}

/// c2CapsuletoPolyManifold.
CuteAnswer of_capsule_and_polygon(const Shape& capsule, const Shape& polygon, unsigned mended) {
  const Nearest nearest = nearest_by_cute(capsule, polygon);
  if (!(nearest.distance < 1.0e-6F) && !has(mended, FaultOfCute::inside)) {
    if (!(nearest.distance < capsule.radius)) return apart_by(nearest.distance);
    const Vector2<float> n = unit_of(nearest.on_b - nearest.on_a);
    return one_point(Way::nearest, n, nearest.on_a, capsule.radius,
                     capsule.radius - nearest.distance, nearest.distance);
  }
  const Vector2<float> a = placed_back(polygon.placing, capsule.vertices[0]);
  const Vector2<float> b = placed_back(polygon.placing, capsule.vertices[1]);
  const Vector2<float> along = unit_of(a - b);
  const auto side_of = [&](const Vector2<float>& normal) { return Plane{normal, a.dot(normal)}; };
  const Plane first = side_of(clockwise_quarter(along));
  const Plane second = side_of(counter_clockwise_quarter(along));
  const auto separation = [&](const Plane& side) {
    return side.distance(polygon.vertices[polygon.support(-side.normal)]);
  };
  BestFace best;
  for (std::size_t i = 0; i < polygon.count(); ++i) {
    const Plane face = plane_at(polygon, i);
    const float d = face.distance(a.dot(-face.normal) > b.dot(-face.normal) ? a : b);
    if (d > best.separation) best = {i, d};
  }
  const float of_sides = std::max(best.separation, separation(first));
  if (separation(second) > of_sides) {
    return of_side(capsule, polygon, second, {capsule.vertices[0], capsule.vertices[1]}, {a, b},
                   mended);
  }
  if (of_sides > best.separation) {
    return of_side(capsule, polygon, first, {capsule.vertices[1], capsule.vertices[0]}, {b, a},
                   mended);
  }
  Segment core{capsule.vertices[0], capsule.vertices[1]};
  const auto plane = clip_by_face(core, polygon, best.index, mended);
  if (!plane) return {};
  CuteAnswer answer = keep_deep(core, *plane, capsule.radius, true);
  if (has(mended, FaultOfCute::on_core)) move_to_surface(answer.contact, capsule);
  return answer;
}

/// c2CheckFaces.
BestFace check_faces(const Shape& a, const Shape& b) {
  const Pose<float> b_in_a = relative_pose(a.placing, b.placing);
  const Pose<float> a_in_b = relative_pose(b.placing, a.placing);
  BestFace best;
  for (std::size_t i = 0; i < a.count(); ++i) {
    const Plane face = plane_at(a, i);
    const std::size_t deepest = b.support(rotate<float>(a_in_b.rotation, -face.normal));
    const float d = face.distance(transform(b_in_a, b.vertices[deepest]));
    if (d > best.separation) best = {i, d};
  }
  return best;
}

/// c2PolytoPolyManifold.
CuteAnswer of_polygons(const Shape& a, const Shape& b, unsigned mended) {
  const BestFace of_a = check_faces(a, b);
  const BestFace of_b = check_faces(b, a);
  if (of_a.separation >= 0 || of_b.separation >= 0) return {};
  const float relative = has(mended, FaultOfCute::bias) ? 1.0F : 0.95F;  // kRelTol
  const float absolute = has(mended, FaultOfCute::bias) ? 0.0F : 0.01F;  // kAbsTol
  const bool is_of_a = of_a.separation * relative > of_b.separation + absolute;
  const Shape& reference = is_of_a ? a : b;
  const Shape& other_one = is_of_a ? b : a;
  const std::size_t face = is_of_a ? of_a.index : of_b.index;
  const Vector2<float> normal = rotate(reference.placing.rotation, reference.normals[face]);
  Segment incident = incident_edge(other_one, rotate_back(other_one.placing.rotation, normal));
  const auto plane = clip_by_face(incident, reference, face, mended);
  if (!plane) return {};
  CuteAnswer answer = keep_deep(incident, *plane, 0, !is_of_a);
  answer.own_normal = (is_of_a ? normal : -normal).cast<double>();
  return answer;
}

/// In the order in which the functions take them.
CuteAnswer in_order(const Shape& first, const Shape& second, unsigned mended) {
  if (first.count() > 2) return of_polygons(first, second, mended);
  if (second.count() > 2 && first.count() == 1) return of_circle_and_polygon(first, second);
  if (second.count() > 2) return of_capsule_and_polygon(first, second, mended);
  if (second.count() == 1) return of_circles(first, second);
  return of_capsules(first, second, first.count() == 2 ? first : second);
}

}  // namespace

CuteAnswer by_cute(const PairCase& pair, unsigned mended) {
  const Shape a(pair.a);
  const Shape b(pair.b);
  const bool is_swapped = std::min<std::size_t>(a.count(), 3) > std::min<std::size_t>(b.count(), 3);
  CuteAnswer answer = is_swapped ? in_order(b, a, mended) : in_order(a, b, mended);
  if (is_swapped) {
    answer.contact.normal = -answer.contact.normal;
    answer.out = -answer.out;
  }
  return answer;
}

}  // namespace manifuzz::as_cute
