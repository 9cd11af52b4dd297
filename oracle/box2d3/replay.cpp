#include "oracle/box2d3/replay.hpp"

#include <algorithm>
#include <limits>

#include "oracle/box2d3/faces.hpp"
#include "oracle/box2d3/floats.hpp"

namespace manifuzz::ledger_of {
namespace {

using box2d3::Float2;
using box2d3::Found;
using box2d3::Placed;

/// b2MakeCapsule's normals.
void set_normals_of_capsule(ConvexPolygon<float>& shape) {
  if (shape.count != 2) return;
  const Float2 axis = box2d3::normalized(shape.vertices[1] - shape.vertices[0]);
  shape.normals[0] = {axis.y(), -axis.x()};
  shape.normals[1] = -shape.normals[0];
}

/// The order in which its functions take them: segments, then polygons, then capsules.
int order_of(const ConvexPolygon<float>& shape) {
  if (shape.count > 2) return 1;
  return shape.radius == 0 ? 0 : 2;
}

Placed placed_by_box2d3(const PairCase& pair) {
  const bool is_swapped = order_of(pair.a.polygon) > order_of(pair.b.polygon);
  const Body& first = is_swapped ? pair.b : pair.a;
  const Body& second = is_swapped ? pair.a : pair.b;
  Placed placed{first.polygon, second.polygon, is_swapped ? Side::b : Side::a};
  set_normals_of_capsule(placed.first);
  set_normals_of_capsule(placed.second);
  const Float2 origin = placed.first.vertices[0];
  Pose<float> between = relative_pose(first.pose, second.pose);
  between.position -= origin;
  for (int i = 0; i < placed.first.count; ++i) placed.first.vertices[i] -= origin;
  for (int i = 0; i < placed.second.count; ++i) {
    placed.second.vertices[i] = transform(between, placed.second.vertices[i]);
    placed.second.normals[i] = rotate(between.rotation, placed.second.normals[i]);
  }
  return placed;
}

/// b2ClipPolygons.
void clip_edges(Found& found, const ConvexPolygon<float>& on, int face,
                const ConvexPolygon<float>& of, int edge) {
  const Float2& normal = on.normals[face];
  const Float2 tangent = counter_clockwise_quarter(normal);
  const Float2& v11 = on.vertices[face];
  const Float2& v21 = of.vertices[edge];
  const Float2& v22 = of.vertices[of.next(edge)];
  const float upper1 = (on.vertices[on.next(face)] - v11).dot(tangent);
  const float upper2 = (v21 - v11).dot(tangent);
  const float lower2 = (v22 - v11).dot(tangent);
  found.is_disjoint = upper2 < 0 || upper1 < lower2;
  if (found.is_disjoint) return;
  const bool is_long = upper2 - lower2 > box2d3::kEpsilon;
  const bool is_low = lower2 < 0;
  const bool is_high = upper2 > upper1;
  found.is_unclipped = !is_long && (is_low || is_high);
  const Float2 lower =
      is_low && is_long ? box2d3::lerp(v22, v21, (0.0F - lower2) / (upper2 - lower2)) : v22;
  const Float2 upper =
      is_high && is_long ? box2d3::lerp(v22, v21, (upper1 - lower2) / (upper2 - lower2)) : v21;
  for (const Float2& place : {lower, upper}) {
    const float distance = (place - v11).dot(normal);
    found.points.push_back(box2d3::clipped_point(place, normal, distance, on.radius, of.radius));
  }
  found.is_clipped = true;
}

/// b2CollidePolygons.
Found polygons(const Placed& placed) {
  const ConvexPolygon<float>& a = placed.first;
  const ConvexPolygon<float>& b = placed.second;
  const float radius = placed.radius();
  const auto on_a = box2d3::best_face<float>(a, b);
  const auto on_b = box2d3::best_face<float>(b, a);
  Found found;
  if (std::max(on_a.separation, on_b.separation) > box2d3::kSpeculative + radius) return found;
  const bool is_by_a = on_a.separation >= on_b.separation;
  const int i = is_by_a ? on_a.index : box2d3::most_opposed(a, b.normals[on_b.index]);
  const int j = is_by_a ? box2d3::most_opposed(b, a.normals[on_a.index]) : on_b.index;
  found.are_apart = std::max(on_a.separation, on_b.separation) > box2d3::kTenth;
  box2d3::SegmentDistance nearest;
  float separation = 0;
  if (found.are_apart) {
    nearest = box2d3::segment_distance(a.vertices[i], a.vertices[a.next(i)], b.vertices[j],
                                       b.vertices[b.next(j)]);
    separation = std::sqrt(nearest.square) - radius;
    if (separation > box2d3::kSpeculative) return found;
  }
  found.normal = is_by_a ? a.normals[i] : Float2(-b.normals[j]);
  clip_edges(found, is_by_a ? a : b, is_by_a ? i : j, is_by_a ? b : a, is_by_a ? j : i);
  const float least = found.is_disjoint
                          ? std::numeric_limits<float>::max()
                          : std::min(found.points[0].separation, found.points[1].separation);
  if (!found.are_apart || separation + box2d3::kTenth >= least || !nearest.are_ends()) return found;
  const float inverse = 1.0F / std::sqrt(nearest.square);
  const Float2& from = a.vertices[nearest.share1 == 0 ? i : a.next(i)];
  const Float2& to = b.vertices[nearest.share2 == 0 ? j : b.next(j)];
  found.normal = {(to.x() - from.x()) * inverse, (to.y() - from.y()) * inverse};
  found.points = {box2d3::single_point(from, to, found.normal, separation, placed)};
  found.is_clipped = false;
  return found;
}

}  // namespace

std::optional<ContactOfBox2d3> contact_of_box2d3(const PairCase& pair) {
  if (std::min(pair.a.polygon.count, pair.b.polygon.count) < 2) return std::nullopt;
  const Placed placed = placed_by_box2d3(pair);
  ContactOfBox2d3 contact;
  contact.is_of_capsules = pair.a.polygon.count == 2 && pair.b.polygon.count == 2;
  const Found found = contact.is_of_capsules ? box2d3::collide_capsules(placed) : polygons(placed);
  const Body& first = pair[placed.side];
  const Pose<double> pose{first.pose.position.cast<double>(), first.pose.rotation.cast<double>()};
  for (const box2d3::PointOf& point : found.points) {
    if (point.separation > 0) continue;
    const Float2 at = point.at + first.polygon.vertices[0];
    contact.points.push_back(
        {transform<double>(pose, at.cast<double>()), -static_cast<double>(point.separation)});
  }
  const Vector2<double> turn = pose.rotation.normalized();
  contact.normal = rotate<double>(turn, found.normal.cast<double>());
  if (placed.side == Side::b) contact.normal = -contact.normal;
  contact.is_clipped = found.is_clipped;
  contact.is_disjoint = found.is_disjoint;
  contact.is_unclipped = found.is_unclipped;
  contact.are_apart = found.are_apart;
  contact.is_beyond_range = found.is_beyond_range;
  return contact;
}

}  // namespace manifuzz::ledger_of
