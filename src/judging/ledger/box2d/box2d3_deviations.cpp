#include <algorithm>
#include <cmath>

#include "judging/ledger/differences.hpp"
#include "judging/ledger/round_deviations.hpp"
#include "oracle/exact/curve.hpp"

// Box2D 3.2 on circles, capsules and rounded polygons.

namespace manifuzz {
namespace {

constexpr double kFaceSlopOfBox2d3 = 0.0005;  // manifold.c: 0.1f * linearSlop

/// b2CollideCapsuleAndCircle's difference from the nearest place on the core to the circle's
/// centre, in the core's frame.
Vector2<float> to_centre_by_box2d3(const Body& core, const Body& circle) {
  const Pose<float> between = relative_pose(core.pose, circle.pose);
  const Vector2<float> centre = transform(between, circle.polygon.vertices[0]);
  const Vector2<float>& from = core.polygon.vertices[0];
  const Vector2<float>& to = core.polygon.vertices[1];
  const Vector2<float> edge = to - from;
  const float before = (centre - from).dot(edge);
  if (before < 0) return centre - from;
  if ((to - centre).dot(edge) < 0) return centre - to;
  return centre - (from + before / edge.dot(edge) * edge);
}

/// Whether an incident edge is, along a face, beyond its ends, or too near them to tell.
bool is_beyond_ends(const Deviation& d, const exact::RoughPair& placed, exact::FaceOf face,
                    int incident) {
  const exact::RoughPolygon& on = placed[face.side];
  const exact::RoughPolygon& of = placed[other(face.side)];
  const Vector2<double>& out = on.normals[face.index];
  const Vector2<double> along(-out.y(), out.x());
  const Vector2<double>& corner = on.vertices[face.index];
  const double length = (on.vertices[on.next(face.index)] - corner).dot(along);
  const double first = (of.vertices[incident] - corner).dot(along);
  const double last = (of.vertices[of.next(incident)] - corner).dot(along);
  const double bound = 2 * d.right.bounds.separation;
  return std::max(first, last) <= bound || std::min(first, last) >= length - bound;
}

}  // namespace

bool direction_of_rounded_place(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const Side circle = pair.a.polygon.count == 1 ? Side::a : Side::b;
  const Body& core = pair[other(circle)];
  if (d.got.count != 1 || pair[circle].polygon.count != 1 || core.polygon.count != 2) return false;
  const Bounds& bounds = d.right.bounds;
  const double least = ledger_of::least_depth(d);
  if (std::abs(d.got.points[0].depth - least) > 4 * bounds.separation) return false;
  const Vector2<double> apart = to_centre_by_box2d3(core, pair[circle]).cast<double>();
  const Vector2<double> turned =
      rotate<double>(core.pose.rotation.cast<double>(), apart.normalized());
  const Vector2<double> normal =
      rotate<double>(pair.a.pose.rotation.cast<double>(), d.got.normal).normalized();
  const Vector2<double> found =
      (circle == Side::b ? turned : Vector2<double>(-turned)).normalized();
  if ((normal - found).norm() > 2 * bounds.normal) return false;
  // The place is off by no more than its roundings, whatever that makes of the direction.
  const Vector2<double> right =
      rotate<double>(pair.a.pose.rotation.cast<double>(),
                     exact::PenetrationCurve(*d.right.truth, exact::Skin::round).minima(0).front());
  const double distance = total_radius(pair) - least;
  return (found - right).norm() * distance <= 4 * bounds.separation;
}

bool corner_beyond_slab(const Deviation& d) {
  const exact::Truth& truth = *d.right.truth;
  const double bound = 2 * d.right.bounds.separation;
  if (d.got.count > 0 || total_radius(d.right.pair()) == 0 || !truth.has_faces(Side::a) ||
      !truth.has_faces(Side::b) || ledger_of::least_depth(d) <= bound) {
    return false;
  }
  const double most = std::max(truth.separation(Side::a), truth.separation(Side::b));
  if (most > kFaceSlopOfBox2d3 + bound) return false;
  const exact::RoughPair placed = exact::place_roughly(truth.stored());
  return std::ranges::any_of(exact::all_faces(truth.stored()), [&](const exact::FaceOf& face) {
    return truth.separation(face) >= most - bound &&
           std::ranges::any_of(
               truth.incident_edges(face, d.right.bounds.incident_dot),
               [&](int incident) { return is_beyond_ends(d, placed, face, incident); });
  });
}

bool face_within_box2d3_slop(const Deviation& d) {
  const exact::Truth& truth = *d.right.truth;
  const PairCase& pair = d.right.pair();
  const double bound = 4 * d.right.bounds.separation;
  const double lost = ledger_of::least_depth(d) - ledger_of::deepest(d.got);
  if (d.got.count == 0 || !is_round(pair) || lost < -bound || lost > kFaceSlopOfBox2d3 + bound) {
    return false;
  }
  const exact::RoughPair placed = exact::place_roughly(truth.stored());
  const Vector2<double> normal =
      rotate<double>(pair.a.pose.rotation.cast<double>(), d.got.normal).normalized();
  return std::ranges::any_of(exact::all_faces(truth.stored()), [&](const exact::FaceOf& face) {
    const Vector2<double>& out = placed[face.side].normals[face.index];
    const Vector2<double> of_face = face.side == Side::a ? out : Vector2<double>(-out);
    return pair[face.side].polygon.count >= 2 &&
           truth.separation(face) >= truth.separation() - bound &&
           (normal - of_face).norm() <= 2 * d.right.bounds.normal;
  });
}

}  // namespace manifuzz
