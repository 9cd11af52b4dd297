#include <algorithm>
#include <cmath>

#include "oracle/dyn4j/detectors.hpp"

namespace manifuzz::as_dyn4j {
namespace {

using replayed::has;

/// ClippingManifoldSolver.clip.
std::vector<Vector2<double>> clip_by_dyn4j(const Vector2<double>& p, const Vector2<double>& q,
                                           const Vector2<double>& out, double offset) {
  std::vector<Vector2<double>> left;
  const double first = out.dot(p) - offset;
  const double second = out.dot(q) - offset;
  if (first <= 0) left.push_back(p);
  if (second <= 0) left.push_back(q);
  if (first * second < 0) {
    const double share = first / (first - second);
    const Vector2<double> along = q - p;
    left.emplace_back(along.x() * share + p.x(), along.y() * share + p.y());
  }
  return left;
}

/// What is left of the incident edge between the reference edge's ends: `tangent` is its unit
/// direction.
std::vector<Vector2<double>> between_ends_of(const FarthestFeature& reference,
                                             const FarthestFeature& incident,
                                             const Vector2<double>& tangent) {
  auto left = clip_by_dyn4j(incident.from, incident.to, -tangent, -tangent.dot(reference.from));
  if (left.size() < 2) return {};
  left = clip_by_dyn4j(left[0], left[1], tangent, tangent.dot(reference.to));
  if (left.size() < 2) return {};
  return left;
}

/// Whether the first edge is less perpendicular to the normal, as their lengths have it or not.
bool is_less_perpendicular(const FarthestFeature& first, const FarthestFeature& second,
                           const Vector2<double>& normal, bool is_by_angle) {
  const double of_first = std::abs(first.edge.dot(normal));
  const double of_second = std::abs(second.edge.dot(normal));
  if (!is_by_angle) return of_first > of_second;
  return of_first * second.edge.norm() > of_second * first.edge.norm();
}

/// The end of an edge that is nearest to what is between another one's ends.
Vector2<double> end_nearest_to(const FarthestFeature& reference, const FarthestFeature& incident,
                               const Vector2<double>& tangent) {
  const auto beyond = [&](const Vector2<double>& at) {
    return std::max(tangent.dot(reference.from - at), tangent.dot(at - reference.to));
  };
  return beyond(incident.from) < beyond(incident.to) ? incident.from : incident.to;
}

replayed::Contact single_point(const Vector2<double>& at, const Found& found) {
  return {found.normal, {{at, found.depth}}};
}

}  // namespace

replayed::Contact clipped_by_dyn4j(const Found& found, const Placed& a, const Placed& b,
                                   unsigned mended) {
  Found along = found;
  const FarthestFeature of_a = a.farthest_feature(along.normal, mended);
  if (!of_a.is_edge) return single_point(of_a.from, along);
  Vector2<double> back = -along.normal;
  const FarthestFeature of_b = b.farthest_feature(back, mended);
  if (!of_b.is_edge) {
    along.normal = -back;
    return single_point(of_b.from, along);
  }
  const bool is_of_b =
      is_less_perpendicular(of_a, of_b, along.normal, has(mended, FaultOfDyn4j::longer_edges));
  const FarthestFeature& reference = is_of_b ? of_b : of_a;
  const FarthestFeature& incident = is_of_b ? of_a : of_b;
  Vector2<double> tangent =
      has(mended, FaultOfDyn4j::placed_vertices) ? reference.along : reference.edge;
  normalize(tangent);
  Vector2<double> sides = tangent;
  // Ends that are cut along the normal are cut across its tangent.
  if (has(mended, FaultOfDyn4j::normal_of_edge)) {
    sides = {-along.normal.y(), along.normal.x()};
    if (sides.dot(tangent) < 0) sides = -sides;
  }
  const auto left = between_ends_of(reference, incident, sides);
  if (left.empty() && has(mended, FaultOfDyn4j::longer_capsule) &&
      (a.is_capsule() || b.is_capsule())) {
    return single_point(end_nearest_to(reference, incident, sides), along);
  }
  replayed::Contact manifold;
  const Vector2<double> front(-tangent.y(), tangent.x());
  const double offset = front.dot(reference.max);
  // The engine's normal of the manifold points from B to A.
  manifold.normal = is_of_b ? front : Vector2<double>(-front);
  double steep = 1;
  if (has(mended, FaultOfDyn4j::normal_of_edge)) {
    steep = std::abs(front.dot(along.normal));
    manifold.normal = along.normal;
  }
  for (const Vector2<double>& at : left) {
    const double depth = (front.dot(at) - offset) / steep;
    if (depth >= 0) manifold.points.push_back({at, depth});
  }
  return manifold;
}

}  // namespace manifuzz::as_dyn4j
