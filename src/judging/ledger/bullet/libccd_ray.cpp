#include "judging/ledger/bullet/libccd_ray.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "judging/ledger/differences.hpp"

// libccd 2.1, mpr.c, discoverPortal and findPenetrSegment, in the plane: both prisms are as high,
// so the ray from the middle stays in it.

namespace manifuzz {
namespace {

constexpr double kCcdEpsilon = std::numeric_limits<double>::epsilon();

/// What oracle/libccd/prism.hpp makes of a body.
std::vector<Vector2<double>> placed_for_ccd(const Body& body) {
  std::vector<Vector2<double>> placed;
  const Vector2<double> turn = body.pose.rotation.cast<double>();
  const Vector2<double> place = body.pose.position.cast<double>();
  for (int i = 0; i < body.polygon.count; ++i) {
    const Vector2<double> vertex = body.polygon.vertices[i].cast<double>();
    placed.emplace_back(turn.x() * vertex.x() - turn.y() * vertex.y() + place.x(),
                        turn.y() * vertex.x() + turn.x() * vertex.y() + place.y());
  }
  return placed;
}

Vector2<double> mean_of(const std::vector<Vector2<double>>& vertices) {
  Vector2<double> sum(0, 0);
  for (const Vector2<double>& vertex : vertices) sum += vertex;
  return sum / static_cast<double>(vertices.size());
}

const Vector2<double>& farthest_of(const std::vector<Vector2<double>>& vertices,
                                   const Vector2<double>& along) {
  std::size_t best = 0;
  const auto reach = [&](std::size_t i) {
    return vertices[i].x() * along.x() + vertices[i].y() * along.y();
  };
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    if (reach(i) > reach(best)) best = i;
  }
  return vertices[best];
}

}  // namespace

bool translation_to_corner_of_ray(const Deviation& d) {
  if (d.got.count == 0) return false;
  const auto a = placed_for_ccd(d.right.pair().a);
  const auto b = placed_for_ccd(d.right.pair().b);
  Vector2<double> middle = mean_of(a) - mean_of(b);
  if (middle.cwiseAbs().maxCoeff() < kCcdEpsilon) middle.x() += 10 * kCcdEpsilon;
  const Vector2<double> along = -middle * (1 / std::sqrt(middle.dot(middle)));
  const Vector2<double> corner = farthest_of(a, along) - farthest_of(b, Vector2<double>(-along));
  const double area = cross<double>(middle, corner);
  const double bound = 4 * d.right.bounds.separation;
  return area * area < kCcdEpsilon && (ledger_of::translation_of(d) - corner).norm() <= bound;
}

}  // namespace manifuzz
