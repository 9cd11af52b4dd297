#include "oracle/chipmunk/replay.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracle/chipmunk/deviations.hpp"
#include "oracle/chipmunk/search.hpp"

// What cpCollision.c of Chipmunk 7, and collision.go of cp, make of closest points.

namespace manifuzz::munk {
namespace {

struct Edge {
  Vector from;
  Vector to;
};

Edge support_edge(const Port& port, const Shape& shape, const Vector& n) {
  const auto& at = shape.corners;
  if (at.size() == 2) {
    return shape.normals[0].dot(n) > 0 ? Edge{at[0], at[1]} : Edge{at[1], at[0]};
  }
  const std::size_t i = support_of(shape, n);
  const std::size_t next = shape.after(i);
  const Edge before{at[shape.before(i)], at[i]};
  const Edge after{at[i], at[next]};
  // The sine of how far an edge is turned; one without length is not met.
  const auto turn = [&](const Edge& edge) {
    const Vector along = edge.to - edge.from;
    return along.isZero(0) ? 1.0 : std::abs(n.dot(along)) / along.norm();
  };
  const bool is_before = replayed::has(port.mended, Fault::support_edge)
                             ? turn(before) < turn(after)
                             : n.dot(shape.normals[i]) > n.dot(shape.normals[next]);
  return is_before ? before : after;
}

void push(Found& found, const Vector& on_a, const Vector& on_b) {
  found.points[static_cast<std::size_t>(found.count++)] = {on_a, on_b, 0};
}

/// ContactPoints.
void clip(const Port& port, const Shape& a, const Shape& b, const Closest& closest, Found& found) {
  const Vector& n = closest.n;
  const Edge of_a = support_edge(port, a, n);
  const Edge of_b = support_edge(port, b, -n);
  const double a_from = cross(of_a.from, n);
  const double a_to = cross(of_a.to, n);
  const double b_from = cross(of_b.from, n);
  const double b_to = cross(of_b.to, n);
  const double per_a = 1 / (a_to - a_from + port.to_length);
  const double per_b = 1 / (b_to - b_from + port.to_length);
  found.normal = n;
  const auto add = [&](double at_a, double at_b) {
    const Vector on_a =
        n * a.radius + mixed(of_a.from, of_a.to, clamped01((at_a - a_from) * per_a));
    const Vector on_b =
        n * -b.radius + mixed(of_b.from, of_b.to, clamped01((at_b - b_from) * per_b));
    if ((on_b - on_a).dot(n) <= 0) push(found, on_a, on_b);
  };
  add(b_to, a_from);
  add(b_from, a_to);
}

/// CircleToCircle and CircleToSegment: `other` is the place of the other core.
void touch_of_circle(const Shape& circle, const Shape& other, const Vector& place,
                     const Vector& where_one, Found& found) {
  const Vector delta = place - circle.corners[0];
  const double squared = delta.dot(delta);
  const double reach = circle.radius + other.radius;
  if (!(squared < reach * reach)) return;
  const double distance = std::sqrt(squared);
  found.normal = distance != 0 ? Vector(delta * (1 / distance)) : where_one;
  push(found, circle.corners[0] + found.normal * circle.radius,
       place + found.normal * -other.radius);
}

/// What it finds of shapes in Chipmunk's order.
Found found_in_order(const Port& port, const Shape& a, const Shape& b) {
  Found found;
  if (b.corners.size() == 1) {
    touch_of_circle(a, b, b.corners[0], Vector(1, 0), found);
  } else if (a.corners.size() == 1 && b.corners.size() == 2) {
    const Vector along = b.corners[1] - b.corners[0];
    const double share = clamped01(along.dot(a.corners[0] - b.corners[0]) / along.dot(along));
    touch_of_circle(a, b, b.corners[0] + along * share, b.normals[0], found);
  } else {
    const Closest closest = Search(port, a, b).run();
    found.has_equal_corners = closest.has_equal_corners;
    const bool is_of_polygon = a.corners.size() > 1 && b.corners.size() > 2;
    if (is_of_polygon && !(closest.d - a.radius - b.radius <= 0)) return found;
    if (!(closest.d <= a.radius + b.radius)) return found;
    if (a.corners.size() > 1) {
      clip(port, a, b, closest, found);
    } else {
      found.normal = closest.n;
      push(found, closest.a + closest.n * a.radius,
           closest.b + closest.n * (port.of_polygon * b.radius));
    }
  }
  return found;
}

}  // namespace

Port mended(const Port& port, unsigned faults) {
  Port without = port;
  without.mended = faults;
  if (replayed::has(faults, Fault::polygon_radius)) without.of_polygon = Port{}.of_polygon;
  if (replayed::has(faults, Fault::length)) without.to_length = kChipmunk.to_length;
  return without;
}

Found found_by(const Port& port, const PairCase& pair) {
  const Vector origin = replayed::has(port.mended, Fault::world)
                            ? Vector(pair.a.pose.position.cast<double>())
                            : Vector(0, 0);
  const Shape a = placed(port, pair.a, origin);
  const Shape b = placed(port, pair.b, origin);
  const auto order = [](const Shape& shape) {
    return std::min<std::size_t>(shape.corners.size(), 3);
  };
  const bool is_swapped = order(a) > order(b);
  Found found = is_swapped ? found_in_order(port, b, a) : found_in_order(port, a, b);
  found.origin = origin;
  const Vector normal = is_swapped ? Vector(-found.normal) : found.normal;
  // Their distance is that of the points as they were found, along the normal as it is given.
  const Vector along = replayed::has(port.mended, Fault::distance) ? found.normal : normal;
  for (Touch& touch : found.points) {
    touch.distance = (touch.on_b - touch.on_a).dot(along);
    if (is_swapped) std::swap(touch.on_a, touch.on_b);
  }
  found.normal = normal;
  return found;
}

replayed::Contact contact_of(const Found& found, Side reference) {
  replayed::Contact contact{found.normal, {}, found.origin};
  for (int i = 0; i < found.count; ++i) {
    const Touch& touch = found.points[static_cast<std::size_t>(i)];
    contact.points.push_back(
        {reference == Side::b ? touch.on_a : touch.on_b, std::max(-touch.distance, 0.0)});
  }
  return contact;
}

bool is_given_by(const Port& port, const Deviation& d) {
  return replayed::is_same_answer(d, contact_of(found_by(port, d.right.pair()), d.got.reference));
}

bool is_given_by_any(const Deviation& d) {
  return is_given_by(kChipmunk, d) || is_given_by(kMunk, d) || is_given_by(kCp, d);
}

bool is_right(const Deviation& d, const Found& found) {
  const auto is_right_of = [&](Side reference) {
    return replayed::is_right_answer(d, as_chipmunk(), contact_of(found, reference));
  };
  return is_right_of(d.got.reference) || (d.got.count == 0 && is_right_of(other(d.got.reference)));
}

}  // namespace manifuzz::munk
