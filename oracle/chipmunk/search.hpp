#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "oracle/chipmunk/replay.hpp"

// GJK and EPA of cpCollision.c of Chipmunk 7, and collision.go of cp, operation for operation.

namespace manifuzz::munk {

using Vector = Vector2<double>;

inline constexpr int kIterationsMax = 30;

inline double clamped01(double share) {
  return std::max(0.0, std::min(share, 1.0));
}

inline Vector mixed(const Vector& from, const Vector& to, double share) {
  return from * (1.0 - share) + to * share;
}

/// A place between two, by `t` from -1 to 1.
inline Vector mixed_by_t(const Vector& from, const Vector& to, double t) {
  const double half = 0.5 * t;
  return from * (0.5 - half) + to * (0.5 + half);
}

/// Whether c is on the left of the line from a to b, beyond it.
inline bool is_greater(const Vector& a, const Vector& b, const Vector& c) {
  return (b.y() - a.y()) * (a.x() + b.x() - 2 * c.x()) >
         (b.x() - a.x()) * (a.y() + b.y() - 2 * c.y());
}

/// A shape in the world: a circle of one corner, a segment of two, a polygon of more.
struct Shape {
  std::vector<Vector> corners;
  std::vector<Vector> normals;  ///< a segment's one; a polygon's of the edge that ends at a corner
  double radius = 0;
  Vector middle{0, 0};  ///< of the box around it

  std::size_t before(std::size_t i) const { return (i + corners.size() - 1) % corners.size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % corners.size(); }
};

inline Vector normalized(const Port& port, const Vector& v) {
  return v * (1.0 / (std::sqrt(v.dot(v)) + port.to_length));
}

inline std::vector<Vector> normals_of(const Port& port, const std::vector<Vector>& corners) {
  std::vector<Vector> normals;
  if (corners.size() == 2) {
    normals.push_back(clockwise_quarter(normalized(port, corners[1] - corners[0])));
  } else if (corners.size() > 2) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector& from = corners[(i + corners.size() - 1) % corners.size()];
      normals.push_back(normalized(port, clockwise_quarter<double>(corners[i] - from)));
    }
  }
  return normals;
}

/// Corners measured from `origin`, a place in the world.
inline Shape placed(const Port& port, const Body& body, const Vector& origin = {0, 0}) {
  Shape shape;
  for (int i = 0; i < body.polygon.count; ++i) {
    shape.corners.push_back(body.polygon.vertices[i].cast<double>());
  }
  shape.normals = normals_of(port, shape.corners);
  shape.radius = static_cast<double>(body.polygon.radius);
  const Vector turn = body.pose.rotation.cast<double>();
  const Vector at = body.pose.position.cast<double>() - origin;
  for (Vector& normal : shape.normals) normal = rotate(turn, normal);
  Vector low(INFINITY, INFINITY);
  Vector high = -low;
  for (Vector& corner : shape.corners) {
    corner = rotate(turn, corner) + at;
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Vector around(shape.radius, shape.radius);
  shape.middle = mixed(low - around, high + around, 0.5);
  return shape;
}

inline std::size_t support_of(const Shape& shape, const Vector& n) {
  if (shape.corners.size() == 2) return shape.corners[0].dot(n) > shape.corners[1].dot(n) ? 0 : 1;
  double most = -INFINITY;
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < shape.corners.size(); ++i) {
    const double along = shape.corners[i].dot(n);
    if (along > most) {
      most = along;
      farthest = i;
    }
  }
  return farthest;
}

/// A point of the difference, b - a.
struct Corner {
  Vector a;
  Vector b;
  Vector ab;
  std::pair<std::size_t, std::size_t> id;
};

/// Closest points, along n.
struct Closest {
  Vector a;
  Vector b;
  Vector n;
  double d = 0;
  bool has_equal_corners = false;  ///< an edge that EPA was to expand had no length
};

/// GJK and EPA of two shapes.
class Search {
 public:
  Search(const Port& port, const Shape& a, const Shape& b) : port_(port), a_(a), b_(b) {}

  Closest run() const {
    const Vector axis = counter_clockwise_quarter<double>(a_.middle - b_.middle);
    Corner from = support(axis);
    Corner to = support(-axis);
    for (int iteration = 1; iteration <= kIterationsMax;) {
      if (is_greater(to.ab, from.ab, Vector(0, 0))) {
        std::swap(from, to);
        continue;
      }
      const double t = nearest(from.ab, to.ab);
      const Vector n = -1 < t && t < 1 ? counter_clockwise_quarter<double>(to.ab - from.ab)
                                       : Vector(-mixed_by_t(from.ab, to.ab, t));
      const Corner p = support(n);
      if (is_greater(p.ab, from.ab, Vector(0, 0)) && is_greater(to.ab, p.ab, Vector(0, 0))) {
        return expanded({from, p, to});
      }
      if (p.ab.dot(n) <= std::max(from.ab.dot(n), to.ab.dot(n))) break;
      (squared_distance(from.ab, p.ab) < squared_distance(p.ab, to.ab) ? to : from) = p;
      ++iteration;
    }
    return closest(from, to);
  }

 private:
  Corner support(const Vector& n) const {
    const std::size_t of_a = support_of(a_, -n);
    const std::size_t of_b = support_of(b_, n);
    const Vector& at_a = a_.corners[of_a];
    const Vector& at_b = b_.corners[of_b];
    return {at_a, at_b, at_b - at_a, {of_a, of_b}};
  }

  double nearest(const Vector& from, const Vector& to) const {
    const Vector delta = to - from;
    const double squared = delta.dot(delta);
    if (port_.is_guarded && squared == 0) return 0;
    // Where this is 0 over 0 their clamp gives the least.
    const double share = delta.dot(from + to) / squared;
    const double t = share > -1 ? -std::min(share, 1.0) : 1.0;
    const bool is_inside = delta.dot(from) < 0 && delta.dot(to) > 0;
    if (!is_inside || !replayed::has(port_.mended, Fault::ends)) return t;
    return std::clamp(t, std::nextafter(-1.0, 0.0), std::nextafter(1.0, 0.0));
  }

  double squared_distance(const Vector& from, const Vector& to) const {
    const Vector at = mixed_by_t(from, to, nearest(from, to));
    return at.dot(at);
  }

  Closest closest(const Corner& from, const Corner& to) const {
    const double t = nearest(from.ab, to.ab);
    const Vector p = mixed_by_t(from.ab, to.ab, t);
    Closest found{mixed_by_t(from.a, to.a, t), mixed_by_t(from.b, to.b, t),
                  normalized(port_, clockwise_quarter<double>(to.ab - from.ab)), 0};
    found.d = found.n.dot(p);
    if (found.d <= 0 || (-1 < t && t < 1)) return found;
    found.d = std::sqrt(p.dot(p));
    found.n = p * (1 / (found.d + port_.to_length));
    return found;
  }

  /// EPA.
  Closest expanded(std::vector<Corner> hull) const {
    bool has_equal_corners = false;
    for (int iteration = 1;; ++iteration) {
      const std::size_t count = hull.size();
      std::size_t least = 0;
      double distance = INFINITY;
      for (std::size_t i = count - 1, j = 0; j < count; i = j++) {
        const double d = squared_distance(hull[i].ab, hull[j].ab);
        if (d < distance) {
          distance = d;
          least = i;
        }
      }
      const Corner from = hull[least];
      const Corner to = hull[(least + 1) % count];
      has_equal_corners = has_equal_corners || from.ab == to.ab;
      const Corner p = support(counter_clockwise_quarter<double>(to.ab - from.ab));
      const bool is_known = p.id == from.id || p.id == to.id;
      if (is_known || !is_greater(from.ab, to.ab, p.ab) || iteration >= kIterationsMax) {
        Closest found = closest(from, to);
        found.has_equal_corners = has_equal_corners;
        return found;
      }
      std::vector<Corner> grown{p};
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t index = (least + 1 + i) % count;
        const Corner& next = i + 1 < count ? hull[(index + 1) % count] : p;
        if (is_greater(grown.back().ab, next.ab, hull[index].ab)) grown.push_back(hull[index]);
      }
      hull = std::move(grown);
    }
  }

  const Port& port_;
  const Shape& a_;
  const Shape& b_;
};

}  // namespace manifuzz::munk
