#include "oracle/box2d/circles.hpp"

#include <cmath>
#include <limits>

#include "judging/faults/differences.hpp"
#include "oracle/box2d/deviations.hpp"

// Box2D 2.4 on a circle and an edge or a polygon, whose operations are repeated in floats.

namespace manifuzz {
namespace {

using ledger_of::FaultOfBox2dCircle;
using FloatVector = Vector2<float>;

/// b2_epsilon.
constexpr float kEpsilonOfFloat = std::numeric_limits<float>::epsilon();

float dot_of_box2d(const FloatVector& a, const FloatVector& b) {
  return a.x() * b.x() + a.y() * b.y();
}

/// b2Vec2::Normalize.
FloatVector normalized_by_box2d(const FloatVector& v, unsigned mended) {
  if ((mended & FaultOfBox2dCircle::short_direction) != 0) {
    return v.cast<double>().normalized().cast<float>();
  }
  const float length = std::sqrt(dot_of_box2d(v, v));
  if (length < kEpsilonOfFloat) return v;
  const float inverse = 1.0F / length;
  return {v.x() * inverse, v.y() * inverse};
}

/// b2Mul of a transform and a vector.
FloatVector placed_by_transform(const Pose<float>& pose, const FloatVector& v) {
  return rotate(pose.rotation, v) + pose.position;
}

/// A b2Manifold of one point, in the frame of the edge or the polygon.
struct LocalManifold {
  bool is_of_circles = false;  ///< e_circles, which has no normal of its own
  FloatVector normal{0, 0};
  FloatVector at{0, 0};  ///< localPoint
};

/// How far a centre is in front of a face, in doubles and by the face's own direction.
double distance_in_doubles(const ConvexPolygon<float>& core, int face, const FloatVector& centre) {
  const Vector2<double> from = core.vertices[face].cast<double>();
  const Vector2<double> along = core.vertices[core.next(face)].cast<double>() - from;
  const Vector2<double> apart = centre.cast<double>() - from;
  return (along.y() * apart.x() - along.x() * apart.y()) / along.norm();
}

int farthest_in_doubles(const ConvexPolygon<float>& core, const FloatVector& centre) {
  int farthest = 0;
  for (int i = 1; i < core.count; ++i) {
    const bool is_farther =
        distance_in_doubles(core, i, centre) > distance_in_doubles(core, farthest, centre);
    if (is_farther) farthest = i;
  }
  return farthest;
}

/// b2CollidePolygonAndCircle.
std::optional<LocalManifold> of_polygon(const ConvexPolygon<float>& core, const FloatVector& centre,
                                        float radius, unsigned mended) {
  int face = 0;
  float separation = -std::numeric_limits<float>::max();
  for (int i = 0; i < core.count; ++i) {
    const float s = dot_of_box2d(core.normals[i], centre - core.vertices[i]);
    if (s > radius) return std::nullopt;
    if (s > separation) {
      separation = s;
      face = i;
    }
  }
  if ((mended & FaultOfBox2dCircle::tied_face) != 0) face = farthest_in_doubles(core, centre);
  const FloatVector& v1 = core.vertices[face];
  const FloatVector& v2 = core.vertices[core.next(face)];
  const FloatVector middle = 0.5F * (v1 + v2);
  const bool is_outside = (mended & FaultOfBox2dCircle::face) != 0
                              ? separation > 0.0F
                              : !(separation < kEpsilonOfFloat);
  if (!is_outside) return LocalManifold{.normal = core.normals[face], .at = middle};
  const auto from_corner = [&](const FloatVector& corner) -> std::optional<LocalManifold> {
    const FloatVector apart = centre - corner;
    if (dot_of_box2d(apart, apart) > radius * radius) return std::nullopt;
    return LocalManifold{.normal = normalized_by_box2d(apart, mended), .at = corner};
  };
  if (dot_of_box2d(centre - v1, v2 - v1) <= 0.0F) return from_corner(v1);
  if (dot_of_box2d(centre - v2, v1 - v2) <= 0.0F) return from_corner(v2);
  if (dot_of_box2d(centre - middle, core.normals[face]) > radius) return std::nullopt;
  return LocalManifold{.normal = core.normals[face], .at = middle};
}

/// b2CollideEdgeAndCircle of an edge that has two sides.
std::optional<LocalManifold> of_edge(const ConvexPolygon<float>& core, const FloatVector& centre,
                                     float radius, unsigned mended) {
  const FloatVector& from = core.vertices[0];
  const FloatVector& to = core.vertices[1];
  const FloatVector along = to - from;
  FloatVector normal(along.y(), -along.x());
  const float u = dot_of_box2d(along, to - centre);
  const float v = dot_of_box2d(along, centre - from);
  const auto is_beyond = [&](const FloatVector& place) {
    const FloatVector apart = centre - place;
    return dot_of_box2d(apart, apart) > radius * radius;
  };
  for (const auto& [share, end] : {std::pair{v, from}, std::pair{u, to}}) {
    if (share > 0.0F) continue;
    if (is_beyond(end)) return std::nullopt;
    return LocalManifold{.is_of_circles = true, .at = end};
  }
  if (is_beyond(1.0F / dot_of_box2d(along, along) * (u * from + v * to))) return std::nullopt;
  if (dot_of_box2d(normal, centre - from) < 0.0F) normal = {-normal.x(), -normal.y()};
  return LocalManifold{.normal = normalized_by_box2d(normal, mended), .at = from};
}

/// b2WorldManifold::Initialize, with the point on the circle's surface as the adapter gives it.
replayed::Contact in_world(const LocalManifold& found, const Body& core, const Body& circle,
                           unsigned mended) {
  const FloatVector place = placed_by_transform(core.pose, found.at);
  const FloatVector centre = placed_by_transform(circle.pose, circle.polygon.vertices[0]);
  const FloatVector apart = centre - place;
  FloatVector normal(1, 0);
  FloatVector on_core;
  if (found.is_of_circles) {
    if (dot_of_box2d(apart, apart) > kEpsilonOfFloat * kEpsilonOfFloat) {
      normal = normalized_by_box2d(apart, mended & ~FaultOfBox2dCircle::short_direction);
    }
    on_core = place + core.polygon.radius * normal;
  } else {
    normal = rotate(core.pose.rotation, found.normal);
    on_core = centre + (core.polygon.radius - dot_of_box2d(apart, normal)) * normal;
  }
  const FloatVector on_circle = centre - circle.polygon.radius * normal;
  const auto separation = static_cast<double>(dot_of_box2d(on_circle - on_core, normal));
  const FloatVector middle = 0.5F * (on_core + on_circle);
  const Vector2<double> towards = normal.cast<double>();
  return {.normal = towards,
          .points = {{.at = middle.cast<double>() + separation / 2 * towards,
                      .depth = std::max(0.0, -separation)}}};
}

const Declaration& as_box2d() {
  static const Declaration declaration = [] {
    Declaration made;
    made.frame = RoundingFrame::world;
    made.min_vertices = 1;
    made.takes_round = true;
    return made;
  }();
  return declaration;
}

/// Whether the answer is what Box2D finds of the pair, and is right only with a fault mended.
bool is_by_fault_of_circle(const Deviation& d, unsigned fault) {
  const PairCase& pair = d.right.pair();
  const auto found = ledger_of::circle_contact_of_box2d(pair, 0);
  if (!found || !replayed::is_same_answer(d, *found)) return false;
  return replayed::is_needed(fault, FaultOfBox2dCircle::all, [&](unsigned mended) {
    return replayed::is_right_answer(d, as_box2d(),
                                     *ledger_of::circle_contact_of_box2d(pair, mended));
  });
}

/// Whether the normal is as long as an edge below b2_epsilon, whose direction is left as it is, and
/// depths along it are none.
bool is_normal_of_short_edge(const Deviation& d) {
  constexpr double epsilon = kEpsilonOfFloat;
  const auto is_as_long = [&](const ConvexPolygon<float>& core) {
    if (core.count != 2) return false;
    const double length = (core.vertices[1] - core.vertices[0]).cast<double>().norm();
    return length < epsilon && std::abs(d.got.normal.norm() - length) <= 4 * epsilon * length;
  };
  const PairCase& pair = d.right.pair();
  return d.got.count > 0 && ledger_of::deepest(d.got) <= d.right.bounds.separation &&
         (is_as_long(pair.a.polygon) || is_as_long(pair.b.polygon));
}

}  // namespace

std::optional<replayed::Contact> ledger_of::circle_contact_of_box2d(const PairCase& pair,
                                                                    unsigned mended) {
  const Side circle = pair.a.polygon.count == 1 ? Side::a : Side::b;
  const Body& round = pair[circle];
  const Body& core = pair[other(circle)];
  if (round.polygon.count != 1 || core.polygon.count < 2) return std::nullopt;
  const FloatVector centre = rotate_back<float>(
      core.pose.rotation,
      placed_by_transform(round.pose, round.polygon.vertices[0]) - core.pose.position);
  const float radius = core.polygon.radius + round.polygon.radius;
  const auto found = core.polygon.count == 2 ? of_edge(core.polygon, centre, radius, mended)
                                             : of_polygon(core.polygon, centre, radius, mended);
  if (!found) return replayed::Contact{};
  replayed::Contact contact = in_world(*found, core, round, mended);
  if (circle == Side::a) contact.normal = -contact.normal;
  return contact;
}

bool face_within_box2d_epsilon(const Deviation& d) {
  return is_by_fault_of_circle(d, FaultOfBox2dCircle::face);
}

bool tied_face_of_box2d_circle(const Deviation& d) {
  return is_by_fault_of_circle(d, FaultOfBox2dCircle::tied_face);
}

bool tiny_reference_face_of_box2d(const Deviation& d) {
  return tiny_reference_face(d) || is_normal_of_short_edge(d) ||
         ((d.right.pair().a.polygon.count == 2 || d.right.pair().b.polygon.count == 2) &&
          is_by_fault_of_circle(d, FaultOfBox2dCircle::short_direction));
}

}  // namespace manifuzz
