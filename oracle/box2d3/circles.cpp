#include "oracle/box2d3/circles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/curve.hpp"
#include "judging/faults/differences.hpp"
#include "judging/faults/replayed.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d3/capsule_editions.hpp"
#include "oracle/box2d3/floats.hpp"

namespace manifuzz {
namespace {

using ledger_of::box2d3::Float2;

/// b2CollidePolygonAndCircle's face of the greatest separation from a circle's centre.
struct FrontFace {
  int index = 0;
  float separation = -std::numeric_limits<float>::max();
  std::optional<Float2> end;  ///< of its ends, the one that the centre is beyond
};

FrontFace front_face(const ConvexPolygon<float>& core, const Float2& centre) {
  FrontFace face;
  for (int i = 0; i < core.count; ++i) {
    const float s = core.normals[i].dot(centre - core.vertices[i]);
    if (s > face.separation) {
      face.separation = s;
      face.index = i;
    }
  }
  const Float2& v1 = core.vertices[face.index];
  const Float2& v2 = core.vertices[core.next(face.index)];
  if ((centre - v1).dot(v2 - v1) < 0) {
    face.end = v1;
  } else if ((centre - v2).dot(v1 - v2) < 0) {
    face.end = v2;
  }
  return face;
}

/// The circle's centre in the core's frame.
Float2 centre_from(const Body& core, const Body& circle) {
  return transform(relative_pose(core.pose, circle.pose), circle.polygon.vertices[0]);
}

/// b2CollidePolygonAndCircle's difference from a corner to a centre; none where it takes the normal
/// of a face.
std::optional<Float2> to_centre_from_corner(const ConvexPolygon<float>& core,
                                            const Float2& centre) {
  const FrontFace face = front_face(core, centre);
  if (!face.end || !(face.separation > ledger_of::box2d3::kEpsilon)) return std::nullopt;
  return centre - *face.end;
}

/// The difference from the nearest place on the core to the circle's centre, in the core's frame:
/// b2CollideCapsuleAndCircle's, or that of a polygon's corner.
std::optional<Float2> to_centre_by_box2d3(const Body& core, const Body& circle) {
  const Float2 centre = centre_from(core, circle);
  if (core.polygon.count > 2) return to_centre_from_corner(core.polygon, centre);
  const Vector2<float>& from = core.polygon.vertices[0];
  const Vector2<float>& to = core.polygon.vertices[1];
  const Vector2<float> edge = to - from;
  const float before = (centre - from).dot(edge);
  if (before < 0) return centre - from;
  if ((to - centre).dot(edge) < 0) return centre - to;
  return centre - (from + before / edge.dot(edge) * edge);
}

/// A direction out of the core, in its frame, as the normal from A to B in the world.
Vector2<double> normal_in_world(const PairCase& pair, Side circle, const Float2& out) {
  const Body& core = pair[other(circle)];
  const Vector2<double> turned =
      rotate<double>(core.pose.rotation.cast<double>(), out.cast<double>()).normalized();
  return circle == Side::b ? turned : Vector2<double>(-turned);
}

}  // namespace

bool no_normal_within_box2d3_epsilon(const Deviation& d) {
  // At a polygon's corner the depth is taken along the normal.
  const PairCase& pair = d.right.pair();
  const bool has_polygon = std::max(pair.a.polygon.count, pair.b.polygon.count) >= kMinVertices;
  return ledger_of::has_no_normal_within(d, ledger_of::kEpsilonOfBox2d3,
                                         ledger_of::least_depth(d)) ||
         (has_polygon && ledger_of::has_no_normal_within(d, ledger_of::kEpsilonOfBox2d3, 0));
}

bool direction_of_rounded_place(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const Side circle = pair.a.polygon.count == 1 ? Side::a : Side::b;
  const Body& core = pair[other(circle)];
  if (d.got.count != 1 || pair[circle].polygon.count != 1 || core.polygon.count < 2) return false;
  const Bounds& bounds = d.right.bounds;
  const double least = ledger_of::least_depth(d);
  if (std::abs(d.got.points[0].depth - least) > 4 * bounds.separation) return false;
  const auto apart = to_centre_by_box2d3(core, pair[circle]);
  if (!apart) return false;
  const Vector2<double> normal =
      rotate<double>(pair.a.pose.rotation.cast<double>(), d.got.normal).normalized();
  const Vector2<double> found = normal_in_world(pair, circle, *apart);
  if ((normal - found).norm() > 2 * bounds.normal) return false;
  // The place is off by no more than its roundings, whatever that makes of the direction.
  const Vector2<double> right =
      rotate<double>(pair.a.pose.rotation.cast<double>(),
                     exact::PenetrationCurve(*d.right.truth, exact::Skin::round).minima(0).front());
  const double distance = total_radius(pair) - least;
  return (found - right).norm() * distance <= 4 * bounds.separation;
}

bool corner_of_tied_face(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const Side circle = pair.a.polygon.count == 1 ? Side::a : Side::b;
  const Side side = other(circle);
  const Body& core = pair[side];
  if (d.got.count != 1 || pair[circle].polygon.count != 1 || core.polygon.count < 3) return false;
  const auto apart = to_centre_by_box2d3(core, pair[circle]);
  if (!apart) return false;
  const exact::Truth& truth = *d.right.truth;
  const Bounds& bounds = d.right.bounds;
  int tied = 0;
  for (int i = 0; i < core.polygon.count; ++i) {
    if (truth.separation({side, i}) >= truth.separation(side) - 2 * bounds.separation) ++tied;
  }
  const double depth = total_radius(pair) - apart->cast<double>().norm();
  if (tied < 2 || std::abs(d.got.points[0].depth - depth) > 4 * bounds.separation) return false;
  const Vector2<double> normal =
      rotate<double>(pair.a.pose.rotation.cast<double>(), d.got.normal).normalized();
  return (normal - normal_in_world(pair, circle, *apart)).norm() <= 2 * bounds.normal;
}

bool face_within_box2d3_epsilon(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const Side circle = pair.a.polygon.count == 1 ? Side::a : Side::b;
  const Body& core = pair[other(circle)];
  if (pair[circle].polygon.count != 1 || core.polygon.count < kMinVertices) return false;
  const Float2 centre = centre_from(core, pair[circle]);
  const FrontFace face = front_face(core.polygon, centre);
  const bool is_in_front = face.separation > 0 && face.separation <= ledger_of::box2d3::kEpsilon;
  if (!is_in_front || !face.end) return false;
  const double radius = total_radius(pair);
  const Vector2<double> given = normal_in_world(pair, circle, core.polygon.normals[face.index]);
  const double depth = radius - static_cast<double>(face.separation);
  if (!replayed::is_same_separation(d, given, depth)) return false;
  const Float2 apart = centre - *face.end;
  const double of_corner = radius - apart.cast<double>().norm();
  const Declaration as_box2d3{.min_vertices = 1, .takes_round = true};
  if (of_corner < 0) return replayed::is_right_answer(d, as_box2d3, {});
  return replayed::is_right_separation(d, as_box2d3, normal_in_world(pair, circle, apart),
                                       of_corner);
}

}  // namespace manifuzz
