#include <cmath>
#include <limits>
#include <optional>

#include "judging/faults/differences.hpp"
#include "judging/faults/replayed.hpp"
#include "oracle/box2d/deviations.hpp"

// b2CollidePolygonAndCircle, b2CollideEdgeAndCircle and b2WorldManifold::Initialize of Box2D 2.4,
// as the adapter calls them: the operations are the engine's in their order, in floats.

namespace manifuzz {
namespace {

using replayed::has;
using FloatVector = Vector2<float>;

/// What of them is wrong: a bit each, to be mended alone or together.
enum class FaultOfBox2dCircle : unsigned {
  face = 1,  ///< a centre in front of a face by less than b2_epsilon is taken to be behind
  short_direction = 2,  ///< b2Vec2::Normalize leaves an edge's normal, or the direction from a
                        ///< corner, as it is where that is shorter than b2_epsilon
  tied_face = 4,        ///< of faces that tie in floats one is kept that is not the nearest
};
constexpr unsigned kFaultsOfBox2dCircle = 7;

/// b2_epsilon.
constexpr float kEpsilonOfFloat = std::numeric_limits<float>::epsilon();

/// b2Vec2::Normalize.
FloatVector normalized_by_box2d(const FloatVector& v, unsigned mended) {
  if (has(mended, FaultOfBox2dCircle::short_direction)) {
    return v.cast<double>().normalized().cast<float>();
  }
  const float length = std::sqrt(v.dot(v));
  if (length < kEpsilonOfFloat) return v;
  const float inverse = 1.0F / length;
  return {v.x() * inverse, v.y() * inverse};
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
  double greatest = distance_in_doubles(core, 0, centre);
  for (int i = 1; i < core.count; ++i) {
    const double of_this = distance_in_doubles(core, i, centre);
    if (of_this <= greatest) continue;
    farthest = i;
    greatest = of_this;
  }
  return farthest;
}

/// The face that is nearest to a centre in front of it, or the farthest where there is none:
/// doubles tie, too, where a corner is flatter than they tell.
int nearest_in_doubles(const ConvexPolygon<float>& core, const FloatVector& centre) {
  const auto distance = [&](int face) {
    return ledger_of::distance_to_segment(centre.cast<double>(), core.vertices[face].cast<double>(),
                                          core.vertices[core.next(face)].cast<double>());
  };
  int nearest = farthest_in_doubles(core, centre);
  double least = distance(nearest);
  for (int i = 0; i < core.count; ++i) {
    const double of_this = distance(i);
    if (of_this >= least || distance_in_doubles(core, i, centre) <= 0) continue;
    nearest = i;
    least = of_this;
  }
  return nearest;
}

/// b2CollidePolygonAndCircle.
std::optional<LocalManifold> of_polygon(const ConvexPolygon<float>& core, const FloatVector& centre,
                                        float radius, unsigned mended) {
  int face = 0;
  float separation = -std::numeric_limits<float>::max();
  for (int i = 0; i < core.count; ++i) {
    const float s = core.normals[i].dot(centre - core.vertices[i]);
    if (s > radius) return std::nullopt;
    if (s > separation) {
      separation = s;
      face = i;
    }
  }
  if (has(mended, FaultOfBox2dCircle::tied_face)) face = nearest_in_doubles(core, centre);
  const FloatVector& v1 = core.vertices[face];
  const FloatVector& v2 = core.vertices[core.next(face)];
  const FloatVector middle = 0.5F * (v1 + v2);
  const bool is_outside =
      has(mended, FaultOfBox2dCircle::face) ? separation > 0.0F : !(separation < kEpsilonOfFloat);
  if (!is_outside) return LocalManifold{.normal = core.normals[face], .at = middle};
  const auto from_corner = [&](const FloatVector& corner) -> std::optional<LocalManifold> {
    const FloatVector apart = centre - corner;
    if (apart.dot(apart) > radius * radius) return std::nullopt;
    return LocalManifold{.normal = normalized_by_box2d(apart, mended), .at = corner};
  };
  if ((centre - v1).dot(v2 - v1) <= 0.0F) return from_corner(v1);
  if ((centre - v2).dot(v1 - v2) <= 0.0F) return from_corner(v2);
  if ((centre - middle).dot(core.normals[face]) > radius) return std::nullopt;
  return LocalManifold{.normal = core.normals[face], .at = middle};
}

/// b2CollideEdgeAndCircle of an edge that has two sides.
std::optional<LocalManifold> of_edge(const ConvexPolygon<float>& core, const FloatVector& centre,
                                     float radius, unsigned mended) {
  const FloatVector& from = core.vertices[0];
  const FloatVector& to = core.vertices[1];
  const FloatVector along = to - from;
  FloatVector normal(along.y(), -along.x());
  const float u = along.dot(to - centre);
  const float v = along.dot(centre - from);
  const auto is_beyond = [&](const FloatVector& place) {
    const FloatVector apart = centre - place;
    return apart.dot(apart) > radius * radius;
  };
  for (const auto& [share, end] : {std::pair{v, from}, std::pair{u, to}}) {
    if (share > 0.0F) continue;
    if (is_beyond(end)) return std::nullopt;
    return LocalManifold{.is_of_circles = true, .at = end};
  }
  if (is_beyond(1.0F / along.dot(along) * (u * from + v * to))) return std::nullopt;
  if (normal.dot(centre - from) < 0.0F) normal = {-normal.x(), -normal.y()};
  return LocalManifold{.normal = normalized_by_box2d(normal, mended), .at = from};
}

/// b2WorldManifold::Initialize, with the point on the circle's surface as the adapter gives it.
replayed::Contact in_world(const LocalManifold& found, const Body& core, const Body& circle,
                           unsigned mended) {
  const FloatVector place = transform(core.pose, found.at);
  const FloatVector centre = transform(circle.pose, circle.polygon.vertices[0]);
  const FloatVector apart = centre - place;
  FloatVector normal(1, 0);
  FloatVector on_core;
  if (found.is_of_circles) {
    if (apart.dot(apart) > kEpsilonOfFloat * kEpsilonOfFloat) {
      normal = normalized_by_box2d(
          apart, mended & ~static_cast<unsigned>(FaultOfBox2dCircle::short_direction));
    }
    on_core = place + core.polygon.radius * normal;
  } else {
    normal = rotate(core.pose.rotation, found.normal);
    on_core = centre + (core.polygon.radius - apart.dot(normal)) * normal;
  }
  const FloatVector on_circle = centre - circle.polygon.radius * normal;
  const auto separation = static_cast<double>((on_circle - on_core).dot(normal));
  const FloatVector middle = 0.5F * (on_core + on_circle);
  const Vector2<double> towards = normal.cast<double>();
  return {.normal = towards,
          .points = {{.at = middle.cast<double>() + separation / 2 * towards,
                      .depth = std::max(0.0, -separation)}}};
}

/// What they find of a circle and an edge or a polygon with some faults mended; nothing of any
/// other pair. Without points where they find no contact.
std::optional<replayed::Contact> circle_contact_of_box2d(const PairCase& pair, unsigned mended) {
  const Side circle = pair.a.polygon.count == 1 ? Side::a : Side::b;
  const Body& round = pair[circle];
  const Body& core = pair[other(circle)];
  if (round.polygon.count != 1 || core.polygon.count < 2) return std::nullopt;
  const FloatVector centre = rotate_back<float>(
      core.pose.rotation, transform(round.pose, round.polygon.vertices[0]) - core.pose.position);
  const float radius = core.polygon.radius + round.polygon.radius;
  const auto found = core.polygon.count == 2 ? of_edge(core.polygon, centre, radius, mended)
                                             : of_polygon(core.polygon, centre, radius, mended);
  if (!found) return replayed::Contact{};
  replayed::Contact contact = in_world(*found, core, round, mended);
  if (circle == Side::a) contact.normal = -contact.normal;
  return contact;
}

Declaration as_box2d() {
  return {.frame = RoundingFrame::world, .min_vertices = 1, .takes_round = true};
}

/// Whether the answer is what Box2D finds of the pair, and is right only with a fault mended.
bool is_by_fault_of_circle(const Deviation& d, FaultOfBox2dCircle fault) {
  const PairCase& pair = d.right.pair();
  const auto found = circle_contact_of_box2d(pair, 0);
  if (!found || !replayed::is_same_answer(d, *found)) return false;
  return replayed::is_needed(
      static_cast<unsigned>(fault), kFaultsOfBox2dCircle, [&](unsigned mended) {
        return replayed::is_right_answer(d, as_box2d(), *circle_contact_of_box2d(pair, mended));
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
