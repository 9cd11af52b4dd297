#include "exact/hausdorff.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/placed.hpp"
#include "exact/root_sum.hpp"

namespace manifuzz::exact {
namespace {

using Vertex = Point<Rational>;
using Outline = std::vector<Vertex>;

template <class Vertices>
Outline outline_of(const Vertices& vertices) {
  Outline outline;
  for (const auto& v : vertices) outline.push_back(widen<Rational>(v));
  return outline;
}

Rational squared(const Vertex& v) {
  return dot(v, v);
}

Rational squared_distance(const Vertex& p, const Vertex& from, const Vertex& to) {
  const Vertex edge = to - from;
  const Rational length = squared(edge);
  const Rational along = dot(p - from, edge);
  if (along.sign() <= 0 || length.is_zero()) return squared(p - from);
  if (along >= length) return squared(p - to);
  const Rational across = cross(edge, p - from);
  return across * across / length;
}

/// Whether an even number of edges lies to the right of a point; on an edge, either.
bool is_outside(const Vertex& p, const Outline& outline) {
  bool is_even = true;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vertex& from = outline[i];
    const Vertex& to = outline[(i + 1) % outline.size()];
    if ((from.y > p.y) == (to.y > p.y)) continue;
    if ((cross(to - from, p - from).sign() > 0) == (to.y > from.y)) is_even = !is_even;
  }
  return is_even;
}

/// To the filled outline.
Rational squared_distance(const Vertex& p, const Outline& outline) {
  if (!is_outside(p, outline)) return Rational(0);
  Rational least = squared(p - outline.front());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    least = std::min(least, squared_distance(p, outline[i], outline[(i + 1) % outline.size()]));
  }
  return least;
}

/// How far the farthest vertex of one lies from the other, both filled.
Rational squared_farthest(const Outline& of, const Outline& from) {
  Rational most(0);
  for (const Vertex& v : of) most = std::max(most, squared_distance(v, from));
  return most;
}

/// Whether a circle around each vertex is in the filled outline: farther than `depth` >= 0 behind
/// every edge.
bool are_behind(const Outline& vertices, const Outline& outline, const Rational& depth) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vertex edge = outline[(i + 1) % outline.size()] - outline[i];
    const Rational least = depth * depth * squared(edge);
    for (const Vertex& v : vertices) {
      const Rational left = cross(edge, v - outline[i]);
      if (left.sign() < 0 || left * left < least) return false;
    }
  }
  return true;
}

/// How far the least deep vertex is behind an edge, as near as double says it.
double least_depth(const Outline& vertices, const Outline& outline) {
  double least = INFINITY;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vertex edge = outline[(i + 1) % outline.size()] - outline[i];
    for (const Vertex& v : vertices) {
      const Rational left = cross(edge, v - outline[i]);
      least = std::min(least,
                       static_cast<double>(left) / std::sqrt(static_cast<double>(squared(edge))));
    }
  }
  return least;
}

double farthest(const Outline& of, const Outline& from) {
  return std::sqrt(static_cast<double>(squared_farthest(of, from)));
}

}  // namespace

Alteration::Alteration(const ConvexPolygon<float>& polygon, const UsedVertices& used)
    : polygon_(&polygon), used_(&used) {
  const bool is_same = std::ranges::equal(
      polygon.corners(), used.corners(),
      [](const auto& p, const auto& q) { return p.template cast<double>() == q; });
  const auto radius = static_cast<double>(polygon.radius);
  grown_ = static_cast<double>(used.round_radius.value_or(polygon.radius)) - radius;
  if (is_same && grown_ == 0) return;
  const Outline one = outline_of(polygon.corners());
  const Outline other = outline_of(used.corners());
  const double lost = farthest(one, other) - grown_;
  double gained = farthest(other, one);
  if (gained == 0 && grown_ > 0) gained = -least_depth(other, one);
  distance_ = std::max({lost, gained + grown_, 0.0});
}

bool Alteration::exceeds(double length) const {
  if (distance_ == 0) return false;
  const Outline one = outline_of(polygon_->corners());
  const Outline other = outline_of(used_->corners());
  const auto is_within = [](const Outline& of, const Outline& from, const Rational& most) {
    if (most.sign() < 0) return are_behind(of, from, -most);
    return squared_farthest(of, from) <= most * most;
  };
  return !is_within(one, other, Rational(length) + Rational(grown_)) ||
         !is_within(other, one, Rational(length) - Rational(grown_));
}

}  // namespace manifuzz::exact
