#include "oracle/exact/hausdorff.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/exact/placed.hpp"
#include "oracle/exact/root_sum.hpp"

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
  const Vertex off = p - from;
  const Rational across = edge.x * off.y - edge.y * off.x;
  return across * across / length;
}

/// Whether an even number of edges lies to the right of a point; on an edge, either.
bool is_outside(const Vertex& p, const Outline& outline) {
  bool is_even = true;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vertex& from = outline[i];
    const Vertex& to = outline[(i + 1) % outline.size()];
    if ((from.y > p.y) == (to.y > p.y)) continue;
    const Rational turn = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    if ((turn.sign() > 0) == (to.y > from.y)) is_even = !is_even;
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

Rational squared_alteration(const ConvexPolygon<float>& polygon, const UsedVertices& used) {
  const Outline one = outline_of(polygon.corners());
  const Outline other = outline_of(used.corners());
  Rational most(0);
  for (const Vertex& v : one) most = std::max(most, squared_distance(v, other));
  for (const Vertex& v : other) most = std::max(most, squared_distance(v, one));
  return most;
}

}  // namespace

Alteration::Alteration(const ConvexPolygon<float>& polygon, const UsedVertices& used)
    : polygon_(&polygon), used_(&used) {
  const bool is_same = std::ranges::equal(
      polygon.corners(), used.corners(),
      [](const auto& p, const auto& q) { return p.template cast<double>() == q; });
  if (!is_same) distance_ = std::sqrt(static_cast<double>(squared_alteration(polygon, used)));
}

bool Alteration::exceeds(double length) const {
  if (distance_ == 0) return false;
  return squared_alteration(*polygon_, *used_) > Rational(length) * Rational(length);
}

}  // namespace manifuzz::exact
