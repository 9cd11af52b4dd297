#include "oracle/matter-js/replay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace manifuzz::ledger_of {
namespace {

using Vertices = std::vector<Vector2<double>>;

/// Vertices.centre.
Vector2<double> centre_by_matter(const Vertices& vertices) {
  double area = 0;
  for (std::size_t i = 0, j = vertices.size() - 1; i < vertices.size(); j = i++) {
    area += (vertices[j].x() - vertices[i].x()) * (vertices[j].y() + vertices[i].y());
  }
  Vector2<double> centre(0, 0);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vector2<double>& next = vertices[(i + 1) % vertices.size()];
    centre += (vertices[i] + next) * cross(vertices[i], next);
  }
  const double divisor = 6 * (area / 2);
  return {centre.x() / divisor, centre.y() / divisor};
}

/// Number.toFixed(3), which rounds halves away from 0.
std::string to_three_decimals(double value) {
  if (std::isinf(value) || std::abs(value) >= 1e21) return fmt::format("{}", value);
  const double magnitude = std::abs(value);
  const double whole = std::floor(magnitude);
  const double eighths = (magnitude - whole) * 8;
  // Only odd sixteenths are, of what doubles hold, halfway between two of three decimals.
  const double sixteenths = 2 * eighths;
  const bool is_half = sixteenths == std::floor(sixteenths) && eighths != std::floor(eighths);
  const std::string digits =
      is_half ? fmt::format("{:.0f}.{:03.0f}", whole, std::floor((magnitude - whole) * 1000 + 0.5))
              : fmt::format("{:.3f}", magnitude);
  return value < 0 ? "-" + digits : digits;
}

Vector2<double> face_normal(const Vector2<double>& from, const Vector2<double>& to) {
  const Vector2<double> normal(to.y() - from.y(), from.x() - to.x());
  const double length = std::sqrt(normal.x() * normal.x() + normal.y() * normal.y());
  if (length == 0) return {0, 0};
  return {normal.x() / length, normal.y() / length};
}

/// Axes.fromVertices.
Vertices merged_axes(const Vertices& normals) {
  std::vector<std::string> keys;
  Vertices axes;
  for (const Vector2<double>& normal : normals) {
    const double gradient =
        normal.y() == 0 ? std::numeric_limits<double>::infinity() : normal.x() / normal.y();
    const std::string key = to_three_decimals(gradient);
    const auto found = std::ranges::find(keys, key);
    if (found == keys.end()) {
      keys.push_back(key);
      axes.push_back(normal);
    } else {
      axes[static_cast<std::size_t>(found - keys.begin())] = normal;
    }
  }
  return axes;
}

/// Along an axis, from where to where.
std::array<double, 2> range_of(const Vertices& vertices, const Vector2<double>& axis) {
  std::array<double, 2> range{INFINITY, -INFINITY};
  for (const Vector2<double>& v : vertices) {
    const double dot = v.x() * axis.x() + v.y() * axis.y();
    range = {std::min(range[0], dot), std::max(range[1], dot)};
  }
  return range;
}

/// Vertices.contains, as it is decided, and the other way where that is within the slack.
std::vector<bool> contains(const Vertices& vertices, const Vector2<double>& point, double slack) {
  double outside = -INFINITY;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vector2<double>& from = vertices[i > 0 ? i - 1 : vertices.size() - 1];
    const Vector2<double> edge = vertices[i] - from;
    const double product =
        (point.x() - from.x()) * edge.y() + (point.y() - from.y()) * (from.x() - vertices[i].x());
    outside = std::max(outside, product == 0 ? 0.0 : product / edge.norm());
  }
  const bool is_inside = !(outside > 0);
  if (std::abs(outside) > slack) return {is_inside};
  return {is_inside, !is_inside};
}

/// Collision._findSupports: of `of` along a direction, seen from the other's centre.
std::vector<SupportsOfMatter> supports_of(const BodyOfMatter& of, const BodyOfMatter& seen_from,
                                          const Vector2<double>& direction, double slack) {
  const int count = static_cast<int>(of.vertices.size());
  const auto vertex = [&](int i) { return of.vertices[static_cast<std::size_t>(i)]; };
  const auto distance = [&](int i) {
    return direction.x() * (seen_from.position.x() - vertex(i).x()) +
           direction.y() * (seen_from.position.y() - vertex(i).y());
  };
  double least = distance(0);
  for (int i = 1; i < count; ++i) least = std::min(least, distance(i));
  std::vector<SupportsOfMatter> found;
  for (int i = 0; i < count; ++i) {
    if (distance(i) > least + slack) continue;
    const int previous = (i + count - 1) % count;
    const int next = (i + 1) % count;
    const double nearest = std::min(distance(next), distance(previous));
    for (const int neighbour : {previous, next}) {
      if (distance(neighbour) > nearest + slack) continue;
      const auto insides = contains(seen_from.vertices, vertex(i), slack);
      const auto of_neighbour = contains(seen_from.vertices, vertex(neighbour), slack);
      for (const bool first : insides) {
        for (const bool second : of_neighbour) {
          const bool is_exchanged = first != insides[0] || second != of_neighbour[0];
          found.push_back({{i, neighbour}, {first, second}, is_exchanged});
        }
      }
    }
  }
  return found;
}

/// The supports that are given as points.
void choose_points(CollisionOfMatter& found) {
  found.points.clear();
  const auto give = [&](const BodyOfMatter& body, const SupportsOfMatter& supports, std::size_t k) {
    if (found.points.size() < 2 && supports.is_inside[k]) {
      found.points.push_back(body.vertices[static_cast<std::size_t>(supports.index[k])]);
    }
  };
  for (std::size_t k = 0; k < 2; ++k) give(found.b, found.of_b, k);
  for (std::size_t k = 0; k < 2; ++k) give(found.a, found.of_a, k);
  found.is_none_inside = found.points.empty();
  // supportsB is _supports, which A's have overwritten by then.
  if (found.is_none_inside) {
    found.points.push_back(found.a.vertices[static_cast<std::size_t>(found.of_a.index[0])]);
  }
}

LeastOverlap overlap_along(const BodyOfMatter& first, const BodyOfMatter& second,
                           const Vector2<double>& axis) {
  const auto of_first = range_of(first.vertices, axis);
  const auto of_second = range_of(second.vertices, axis);
  const double ahead = of_first[1] - of_second[0];
  const double behind = of_second[1] - of_first[0];
  return {axis, ahead < behind ? ahead : behind, ahead < behind};
}

/// An overlap that may be the least, along an axis of a side's.
struct OverlapOfSide {
  LeastOverlap overlap;
  Side side = Side::a;
  bool is_exchanged = false;  ///< it is not the first of the least of its side's, or not above 0
};

/// The overlaps within the slack of the least; none where they are apart by more than it.
std::vector<OverlapOfSide> least_overlaps(const BodyOfMatter& a, const BodyOfMatter& b,
                                          double slack) {
  std::vector<OverlapOfSide> all;
  for (const Side side : {Side::a, Side::b}) {
    const BodyOfMatter& first = side == Side::a ? a : b;
    const BodyOfMatter& second = side == Side::a ? b : a;
    const LeastOverlap least = least_overlap(first, second, first.axes);
    for (const Vector2<double>& axis : first.axes) {
      const bool is_exchanged = axis != least.axis || least.overlap <= 0;
      all.push_back({overlap_along(first, second, axis), side, is_exchanged});
    }
  }
  double least = INFINITY;
  for (const OverlapOfSide& each : all) least = std::min(least, each.overlap.overlap);
  std::erase_if(all, [&](const OverlapOfSide& each) {
    return least <= -slack || each.overlap.overlap > least + slack;
  });
  return all;
}

}  // namespace

BodyOfMatter body_of_matter(const Body& body) {
  const Vector2<double> stored = body.pose.rotation.cast<double>();
  const double length = std::sqrt(stored.x() * stored.x() + stored.y() * stored.y());
  const Vector2<double> unit(stored.x() / length, stored.y() / length);
  const Vector2<double> at = body.pose.position.cast<double>();
  BodyOfMatter made;
  for (int i = 0; i < body.polygon.count; ++i) {
    made.vertices.push_back(length * body.polygon.vertices[i].cast<double>());
  }
  const double angle = std::atan2(unit.y(), unit.x());
  const auto turned = [&](const Vector2<double>& v) {
    if (angle == 0) return v;
    return rotate<double>({std::cos(angle), std::sin(angle)}, v);
  };
  for (std::size_t i = 0; i < made.vertices.size(); ++i) {
    made.normals.push_back(
        face_normal(made.vertices[i], made.vertices[(i + 1) % made.vertices.size()]));
  }
  made.axes = merged_axes(made.normals);
  std::ranges::transform(made.axes, made.axes.begin(), turned);
  std::ranges::transform(made.normals, made.normals.begin(), turned);
  const Vector2<double> centre = centre_by_matter(made.vertices);
  made.position = rotate(unit, centre) + at;
  for (Vector2<double>& v : made.vertices) {
    v = (v - centre) + made.position;
    if (angle != 0) v = made.position + turned(v - made.position);
  }
  return made;
}

LeastOverlap least_overlap(const BodyOfMatter& first, const BodyOfMatter& second,
                           const Vertices& axes) {
  LeastOverlap least{.overlap = std::numeric_limits<double>::max()};
  for (const Vector2<double>& axis : axes) {
    const LeastOverlap along = overlap_along(first, second, axis);
    if (along.overlap >= least.overlap) continue;
    least = along;
    if (least.overlap <= 0) break;
  }
  return least;
}

std::vector<CollisionOfMatter> collisions_of_matter(const PairCase& pair, double slack,
                                                    AxesOfMatter axes) {
  CollisionOfMatter found{.a = body_of_matter(pair.a), .b = body_of_matter(pair.b)};
  if (axes == AxesOfMatter::all) {
    found.a.axes = found.a.normals;
    found.b.axes = found.b.normals;
  }
  std::vector<CollisionOfMatter> all;
  const auto of_sides = least_overlaps(found.a, found.b, slack);
  const Vector2<double> apart = found.b.position - found.a.position;
  for (const auto& [of_side, side, is_exchanged] : of_sides) {
    const bool is_ahead = of_side.axis.dot(apart) >= 0;
    found.depth = of_side.overlap;
    found.normal = is_ahead ? of_side.axis : Vector2<double>(-of_side.axis);
    // B is ahead of A along the axis where A's end of it is the one inside of B.
    found.is_turned = is_ahead != (of_side.is_of_first == (side == Side::a));
    for (const auto& of_b : supports_of(found.b, found.a, Vector2<double>(-found.normal), slack)) {
      for (const auto& of_a : supports_of(found.a, found.b, found.normal, slack)) {
        found.of_a = of_a;
        found.of_b = of_b;
        found.is_exchanged = is_exchanged || of_a.is_exchanged || of_b.is_exchanged;
        choose_points(found);
        all.push_back(found);
      }
    }
  }
  std::stable_partition(all.begin(), all.end(),
                        [](const CollisionOfMatter& collision) { return !collision.is_exchanged; });
  return all;
}

}  // namespace manifuzz::ledger_of
