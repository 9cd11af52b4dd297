#include "oracle/bullet/ledger/prisms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manifuzz::ledger_of {
namespace {

/// What oracle/bullet/prism.hpp makes of a body.
BulletHull hull_of_body(const Body& body, float half_height) {
  BulletHull hull;
  for (int i = 0; i < body.polygon.count; ++i) {
    const Vector2<float>& vertex = body.polygon.vertices[i];
    hull.corners.emplace_back(vertex.x(), vertex.y(), half_height);
    if (half_height > 0) hull.corners.emplace_back(vertex.x(), vertex.y(), -half_height);
  }
  hull.margin = body.polygon.radius;
  return hull;
}

BulletPlace place_of_body(const Body& body) {
  const float cos = body.pose.rotation.x();
  const float sin = body.pose.rotation.y();
  return {{Space(cos, -sin, 0), Space(sin, cos, 0), Space(0, 0, 1)},
          Space(body.pose.position.x(), body.pose.position.y(), 0)};
}

float reach_in_float(const Body& body) {
  float farthest = 0;
  for (int i = 0; i < body.polygon.count; ++i) {
    const Vector2<float>& vertex = body.polygon.vertices[i];
    farthest = std::max(farthest, std::hypot(vertex.x(), vertex.y()));
  }
  return farthest + body.polygon.radius;
}

}  // namespace

Space over(const Space& v, float length) {
  return v * (1.0F / length);
}

Space times(const Space& v, const Basis& basis) {
  const auto along = [&](int i) {
    return basis[0][i] * v.x() + basis[1][i] * v.y() + basis[2][i] * v.z();
  };
  return {along(0), along(1), along(2)};
}

Basis times(const Basis& a, const Basis& b) {
  return {times(a[0], b), times(a[1], b), times(a[2], b)};
}

Basis transposed(const Basis& basis) {
  const auto row = [&](int i) { return Space(basis[0][i], basis[1][i], basis[2][i]); };
  return {row(0), row(1), row(2)};
}

Space BulletPlace::to_world(const Space& local) const {
  return Space(dot(basis[0], local), dot(basis[1], local), dot(basis[2], local)) + origin;
}

const Space& BulletHull::farthest(const Space& along) const {
  std::size_t best = 0;
  float most = -std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float far = dot(corners[i], along);
    if (far > most) {
      most = far;
      best = i;
    }
  }
  return corners[best];
}

bool BulletHull::has_farthest(const Space& along) const {
  return std::ranges::any_of(corners, [&](const Space& corner) {
    return dot(corner, along) > -std::numeric_limits<float>::max();
  });
}

Space BulletHull::farthest_of_round(const Space& along) const {
  constexpr float epsilon = std::numeric_limits<float>::epsilon();
  Space unit = squared(along) < epsilon * epsilon ? Space(-1, -1, -1) : along;
  unit = over(unit, std::sqrt(squared(unit)));
  return farthest(unit) + margin * unit;
}

BulletPair prisms_of(const PairCase& pair) {
  const float both = reach_in_float(pair.a) + reach_in_float(pair.b);
  return {hull_of_body(pair.a, 0.7F * both), hull_of_body(pair.b, 0.5F * both),
          place_of_body(pair.a), place_of_body(pair.b), false};
}

BulletPair flat_hulls_of(const PairCase& pair) {
  return {hull_of_body(pair.a, 0), hull_of_body(pair.b, 0), place_of_body(pair.a),
          place_of_body(pair.b), true};
}

// Its box is larger by the margin of 0.04 that a hull is made with, and by its own.
float disc_of(const BulletHull& hull) {
  constexpr float margin_of_new = 0.04F;
  Space low = hull.corners[0];
  Space high = low;
  for (const Space& corner : hull.corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  high += Space::Constant(margin_of_new);
  low -= Space::Constant(margin_of_new);
  const Space extent = 0.5F * (high - low) + Space::Constant(hull.margin);
  const Space middle = 0.5F * (high + low);
  const Space from = middle - extent;
  const Space to = middle + extent;
  const Space centre = (from + to) * 0.5F;
  return std::sqrt(squared(Space(to - from))) * 0.5F + std::sqrt(squared(centre));
}

float breaking_threshold(const BulletPair& pair) {
  return std::min(disc_of(pair.a) * kRelativeBreaking, disc_of(pair.b) * kRelativeBreaking);
}

float farthest_square_of(const BulletPair& pair) {
  if (!pair.is_flat) return 1e18F;
  const float farthest = pair.a.margin + pair.b.margin + breaking_threshold(pair);
  return farthest * farthest;
}

}  // namespace manifuzz::ledger_of
