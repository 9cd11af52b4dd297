#include "oracle/p2-es/replay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "judging/faults/rounded_sum.hpp"

namespace manifuzz::ledger_of {
namespace {

using Branch = ContactOfP2::Branch;
using Wide = Vector2<double>;

/// A vector of a Float32Array: each number is rounded as it is stored.
struct Stored {
  double x = 0;
  double y = 0;

  Stored() = default;
  Stored(double of_x, double of_y)
      : x(static_cast<double>(static_cast<float>(of_x))),
        y(static_cast<double>(static_cast<float>(of_y))) {}

  friend Stored operator+(const Stored& a, const Stored& b) { return {a.x + b.x, a.y + b.y}; }
  friend Stored operator-(const Stored& a, const Stored& b) { return {a.x - b.x, a.y - b.y}; }
  friend Stored operator*(double factor, const Stored& a) { return {a.x * factor, a.y * factor}; }
};

double dot(const Stored& a, const Stored& b) {
  return a.x * b.x + a.y * b.y;
}

Stored normalized(const Stored& a) {
  const double square = dot(a, a);
  return square > 0 ? (1 / std::sqrt(square)) * a : a;
}

Stored clockwise(const Stored& a) {
  return {a.y, -a.x};
}

/// Where a body stands.
struct Frame {
  Stored position;
  double angle = 0;

  Stored to_global(const Stored& local) const {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * local.x - s * local.y + position.x, s * local.x + c * local.y + position.y};
  }
  Stored to_local(const Stored& world) const {
    const double c = std::cos(-angle);
    const double s = std::sin(-angle);
    const double x = world.x - position.x;
    const double y = world.y - position.y;
    return {c * x - s * y, s * x + c * y};
  }
};

/// A body's rotation as the adapter has it.
double angle_of(const Body& body) {
  const Wide stored = body.pose.rotation.cast<double>();
  return std::atan2(stored.y(), stored.x());
}

Wide unit_turn(const Body& body) {
  const Wide stored = body.pose.rotation.cast<double>();
  return stored / std::sqrt(stored.x() * stored.x() + stored.y() * stored.y());
}

Stored centre_of_circle(const Body& body) {
  const Wide v = body.polygon.vertices[0].cast<double>();
  const Wide turn = body.pose.rotation.cast<double>();
  const Wide at = body.pose.position.cast<double>();
  return {ledger_of::sum_rounded_once(turn.x() * v.x(), -turn.y() * v.y(), at.x()),
          ledger_of::sum_rounded_once(turn.y() * v.x(), turn.x() * v.y(), at.y())};
}

/// The normal and the points of a contact equation, from the circle to the other shape.
ContactOfP2 contact(Branch branch, const Stored& normal, const Stored& on_circle,
                    const Stored& on_other) {
  return {branch,
          {normal.x, normal.y},
          std::max(0.0, -dot(normal, on_other - on_circle)),
          {on_other.x, on_other.y}};
}

/// A point relative to a body, which is then added to its position again.
Stored relative(const Stored& point, const Stored& position) {
  return (point - position) + position;
}

ContactOfP2 circle_contact(Branch branch, const Stored& normal, const Stored& centre, double radius,
                           const Stored& on_other, const Stored& position) {
  const Stored on_circle = relative(radius * normal + centre, centre);
  return contact(branch, normal, on_circle, relative(on_other, position));
}

std::optional<ContactOfP2> circle_circle(const Stored& a, double radius_a, const Stored& b,
                                         double radius_b) {
  const Stored apart = a - b;
  const double radius = radius_a + radius_b;
  if (dot(apart, apart) > radius * radius) return std::nullopt;
  const Stored normal = normalized(b - a);
  return contact(Branch::circles, normal, radius_a * normal + a, -radius_b * normal + b);
}

std::optional<ContactOfP2> circle_line(const Stored& centre, double circle_radius,
                                       const Body& capsule, EdgeOfP2 edge) {
  const Wide from = capsule.polygon.vertices[0].cast<double>();
  const Wide to = capsule.polygon.vertices[1].cast<double>();
  const auto line_radius = static_cast<double>(capsule.polygon.radius);
  const Wide unit = unit_turn(capsule);
  const double x = to.x() - from.x();
  const double y = to.y() - from.y();
  const Wide middle((from.x() + to.x()) / 2, (from.y() + to.y()) / 2);
  const Wide at = capsule.pose.position.cast<double>();
  const Frame frame{{unit.x() * middle.x() - unit.y() * middle.y() + at.x(),
                     unit.y() * middle.x() + unit.x() * middle.y() + at.y()},
                    std::atan2(y, x) + angle_of(capsule)};
  const double half = std::sqrt(x * x + y * y) / 2;
  const std::array ends{frame.to_global({-half, 0}), frame.to_global({half, 0})};
  const Stored along = edge == EdgeOfP2::of_ends
                           ? normalized(ends[1] - ends[0])
                           : Stored(std::cos(frame.angle), std::sin(frame.angle));
  const Stored tangent = clockwise(along);
  const double radius = circle_radius + line_radius;
  const double distance = dot(centre - ends[0], tangent);
  if (std::abs(distance) < radius) {
    const Stored across = distance * tangent;
    const Stored towards = normalized(dot(tangent, centre - frame.position) * tangent);
    const Stored on_line = (centre - across) + line_radius * towards;
    const double place = dot(along, on_line);
    if (place > dot(along, ends[0]) && place < dot(along, ends[1])) {
      const Stored normal = normalized(-1.0 * across);
      return circle_contact(Branch::beside_line, normal, centre, circle_radius,
                            relative(on_line, frame.position), frame.position);
    }
  }
  std::array<std::size_t, 2> order{0, 1};
  if (edge == EdgeOfP2::of_angle && dot(along, centre - ends[0]) > dot(along, ends[1] - centre)) {
    std::swap(order[0], order[1]);
  }
  for (const std::size_t i : order) {
    const Stored apart = ends[i] - centre;
    if (!(dot(apart, apart) < radius * radius)) continue;
    const Stored normal = normalized(apart);
    const Stored on_other = ((ends[i] - frame.position) + -line_radius * normal) + frame.position;
    return circle_contact(i == 0 ? Branch::first_end : Branch::second_end, normal, centre,
                          circle_radius, on_other, frame.position);
  }
  return std::nullopt;
}

/// p2's Convex, in its own frame.
struct Convex {
  std::vector<Stored> vertices;
  std::vector<Stored> normals;
  Frame frame;

  std::size_t count() const { return vertices.size(); }
  /// pointInConvexLocal.
  bool contains(const Stored& point) const {
    double last = 0;
    for (std::size_t i = 0; i <= count(); ++i) {
      const Stored from = vertices[i % count()] - point;
      const Stored to = vertices[(i + 1) % count()] - point;
      const double cross = from.x * to.y - from.y * to.x;
      if (i > 0 && cross * last < 0) return false;
      last = cross;
    }
    return true;
  }
};

Convex convex_of(const Body& body) {
  const Wide at = body.pose.position.cast<double>();
  Convex made{{}, {}, {{at.x(), at.y()}, angle_of(body)}};
  for (int i = 0; i < body.polygon.count; ++i) {
    const Wide v = body.polygon.vertices[i].cast<double>();
    made.vertices.emplace_back(v.x(), v.y());
  }
  for (std::size_t i = 0; i < made.count(); ++i) {
    const Stored along = made.vertices[(i + 1) % made.count()] - made.vertices[i];
    made.normals.push_back(normalized(clockwise(along)));
  }
  return made;
}

/// The one of the best face and its neighbours behind which the circle's own point is least deep;
/// by how much.
struct FaceOfP2 {
  std::size_t index = 0;
  double depth = std::numeric_limits<double>::max();
};

std::optional<FaceOfP2> face_of_p2(const Convex& convex, std::size_t best, const Stored& centre,
                                   double radius) {
  FaceOfP2 found;
  bool is_found = false;
  const std::size_t count = convex.count();
  for (std::size_t i = best + count - 1; i < best + count + 2; ++i) {
    const Stored& normal = convex.normals[i % count];
    const Stored candidate = -radius * normal + centre;
    if (!convex.contains(candidate)) continue;
    const double depth = std::abs(dot(convex.vertices[i % count] - candidate, normal));
    if (!(depth < found.depth)) continue;
    found = {i % count, depth};
    is_found = true;
  }
  return is_found ? std::optional(found) : std::nullopt;
}

std::optional<ContactOfP2> circle_convex(const Stored& centre, double radius, const Body& body) {
  const Convex convex = convex_of(body);
  const std::size_t count = convex.count();
  const Stored local = convex.frame.to_local(centre);
  std::size_t best = 0;
  double separation = -std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < count; ++i) {
    const double of_face = dot(convex.normals[i], local - convex.vertices[i]);
    if (of_face > separation) {
      separation = of_face;
      best = i;
    }
  }
  const Stored& position = convex.frame.position;
  if (const auto face = face_of_p2(convex, best, local, radius)) {
    const Stored from = convex.frame.to_global(convex.vertices[face->index]);
    const Stored to = convex.frame.to_global(convex.vertices[(face->index + 1) % count]);
    const Stored out = clockwise(normalized(to - from));
    const Stored candidate = -radius * out + centre;
    const Stored on_face = face->depth * out + candidate;
    return circle_contact(Branch::face, normalized(candidate - centre), centre, radius,
                          relative(on_face, position), position);
  }
  for (std::size_t i = best; i < best + 2; ++i) {
    const Stored apart = convex.vertices[i % count] - local;
    if (!(dot(apart, apart) < radius * radius)) continue;
    const Stored vertex = convex.frame.to_global(convex.vertices[i % count]);
    return circle_contact(Branch::vertex, normalized(vertex - centre), centre, radius,
                          relative(vertex, position), position);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ContactOfP2> circle_contact_of_p2(const PairCase& pair, EdgeOfP2 edge) {
  const bool is_of_a = pair.a.polygon.count == 1;
  if (!is_of_a && pair.b.polygon.count != 1) return std::nullopt;
  const Body& circle = is_of_a ? pair.a : pair.b;
  const Body& body = is_of_a ? pair.b : pair.a;
  const Stored centre = centre_of_circle(circle);
  const auto radius = static_cast<double>(circle.polygon.radius);
  std::optional<ContactOfP2> found;
  if (body.polygon.count == 1) {
    found = circle_circle(centre, radius, centre_of_circle(body),
                          static_cast<double>(body.polygon.radius));
  } else if (body.polygon.count == 2) {
    found = circle_line(centre, radius, body, edge);
  } else {
    found = circle_convex(centre, radius, body);
  }
  if (found && !is_of_a) found->normal = -found->normal;
  return found;
}

}  // namespace manifuzz::ledger_of
