#include "report/picture/scene.hpp"

#include <algorithm>
#include <cmath>

#include "report/candidate.hpp"

namespace manifuzz {
namespace {

PlacedFace placed_face(const Scene& scene, Side side, int face) {
  const exact::RoughPolygon& polygon = scene.polygon(side);
  return {side, face, {polygon.vertices[face], polygon.vertices[polygon.next(face)]}};
}

/// A local point of A, seen from A's position in world directions.
Point seen_from_a(const PairCase& pair, const Point& local) {
  return rotate<double>(pair.a.pose.rotation.cast<double>(), local);
}

/// From the incident skin below a point of the incident edge, along the reference face's normal.
DepthBar bar_at(const Scene& scene, const Point& position, double depth, Side reference,
                const Point& outward) {
  const Point skin = position - scene.radius(other(reference)) * outward;
  return {skin, skin + depth * outward, depth};
}

/// The true deepest point: of the clip, or the vertex that lies farthest behind the reference face.
DepthBar deepest_bar(const Scene& scene, const PairCase& pair, const exact::Clip* candidate) {
  if (candidate != nullptr) {
    const auto& points = candidate->points;
    const bool second = candidate->count > 1 && points[1].depth() > points[0].depth();
    const exact::ClipPoint& point = points[second ? 1 : 0];
    return bar_at(scene, seen_from_a(pair, point.position()), point.depth(), scene.reference.side,
                  scene.outward);
  }
  const exact::RoughPolygon& polygon = scene.polygon(other(scene.reference.side));
  const auto* const deepest = std::min_element(
      polygon.vertices.data(), polygon.vertices.data() + polygon.count,
      [&](const Point& p, const Point& q) { return scene.outward.dot(p) < scene.outward.dot(q); });
  const double separation = scene.outward.dot(*deepest - scene.reference.segment.first);
  return bar_at(scene, *deepest, total_radius(pair) - separation, scene.reference.side,
                scene.outward);
}

void add_points(Scene& scene, const PairCase& pair, const DeclaredAnswer& asked, bool is_subject) {
  for (int i = 0; i < asked.count(); ++i) {
    const Manifold<double>& manifold = *asked.manifold();
    const ContactPoint<double>& point = manifold.points[i];
    const Point normal = world_normal(pair, manifold.normal);
    if (!point.position.allFinite() || !std::isfinite(point.depth) || !normal.allFinite()) continue;
    const Point position = seen_from_a(pair, point.position);
    const Point direction = unit(normal);
    const Point outward = manifold.reference == Side::a ? direction : Point(-direction);
    scene.points.push_back({is_subject, position, normal,
                            bar_at(scene, position, point.depth, manifold.reference, outward)});
  }
}

}  // namespace

Scene make_scene(const JudgedCase& judged) {
  const PairCase& pair = judged.given.pair;
  const auto world = exact::place_roughly(pair);
  const Admissible right = admissible(pair, judged.subject.declaration);
  const exact::Clip* const candidate = candidate_to_show(right, judged.subject);

  Scene scene;
  scene.polygons = {world.a, world.b};
  scene.radii = {pair.a.polygon.radius, pair.b.polygon.radius};
  scene.rounding = right.bounds.separation;

  const auto [side, face] = candidate ? candidate->reference : right.truth->greatest();
  scene.reference = placed_face(scene, side, face);
  if (candidate) scene.incident = placed_face(scene, other(side), candidate->incident);
  scene.outward = scene.polygon(side).normals[face];
  scene.normal = side == Side::a ? scene.outward : Point(-scene.outward);
  const Point widening = total_radius(pair) * counter_clockwise_quarter<double>(scene.outward);
  scene.slab = {scene.reference.segment.first - widening,
                scene.reference.segment.second + widening};
  scene.deepest = deepest_bar(scene, pair, candidate);
  add_points(scene, pair, judged.subject, true);
  add_points(scene, pair, judged.oracle, false);
  return scene;
}

}  // namespace manifuzz
