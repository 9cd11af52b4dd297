#include "oracle/box2d/round_shapes.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_edge_shape.h>

#include "oracle/box2d/box2d.hpp"

namespace manifuzz::box2d {
namespace {

b2CircleShape to_circle(const ConvexPolygon<float>& shape) {
  b2CircleShape circle;
  circle.m_p = to_box2d(shape.vertices[0]);
  circle.m_radius = shape.radius;
  return circle;
}

b2EdgeShape to_edge(const ConvexPolygon<float>& shape) {
  b2EdgeShape edge;
  edge.SetTwoSided(to_box2d(shape.vertices[0]), to_box2d(shape.vertices[1]));
  edge.m_radius = shape.radius;
  return edge;
}

/// In the order in which Box2D's functions take them.
enum class Family { edge, polygon, circle };

Family family_of(const ConvexPolygon<float>& shape) {
  if (shape.count == 1) return Family::circle;
  return shape.count == 2 ? Family::edge : Family::polygon;
}

bool has_round_corners(const ConvexPolygon<float>& shape) {
  return shape.count >= kMinVertices && shape.is_round();
}

std::optional<Unsupported> beyond_box2d(const PairCase& pair) {
  const Family a = family_of(pair.a.polygon);
  const Family b = family_of(pair.b.polygon);
  if (a == Family::circle || b == Family::circle) return std::nullopt;
  if (a == Family::edge && b == Family::edge) return Unsupported{"has no edge against edge"};
  const bool is_round_somewhere =
      has_round_corners(pair.a.polygon) || has_round_corners(pair.b.polygon);
  if (is_round_somewhere && total_radius(pair) > 0) {
    return Unsupported{"its polygons' corners are mitred"};
  }
  return std::nullopt;
}

using Shape = std::variant<b2EdgeShape, b2PolygonShape, b2CircleShape>;

Shape shape_of(const ConvexPolygon<float>& shape) {
  switch (family_of(shape)) {
    case Family::edge:
      return to_edge(shape);
    case Family::circle:
      return to_circle(shape);
    default:
      return to_box2d(shape);
  }
}

/// A shape where it stands.
struct Standing {
  Shape shape;
  b2Transform transform;
};

Standing standing(const Body& body) {
  return {shape_of(body.polygon), to_box2d(body.pose)};
}

/// Box2D's function for two shapes, the first not of a later family than the second.
void collide_by_family(b2Manifold& found, const Standing& first, const Standing& second) {
  const b2Transform& at = first.transform;
  const b2Transform& of_second = second.transform;
  const auto* const circle = std::get_if<b2CircleShape>(&second.shape);
  const auto* const polygon = std::get_if<b2PolygonShape>(&second.shape);
  if (const auto* const edge = std::get_if<b2EdgeShape>(&first.shape)) {
    if (circle != nullptr) return b2CollideEdgeAndCircle(&found, edge, at, circle, of_second);
    return b2CollideEdgeAndPolygon(&found, edge, at, polygon, of_second);
  }
  if (const auto* const other = std::get_if<b2PolygonShape>(&first.shape)) {
    if (circle != nullptr) return b2CollidePolygonAndCircle(&found, other, at, circle, of_second);
    return b2CollidePolygons(&found, other, at, polygon, of_second);
  }
  b2CollideCircles(&found, &std::get<b2CircleShape>(first.shape), at, circle, of_second);
}

/// Whether Box2D's functions take B first.
bool is_swapped(const PairCase& pair) {
  return family_of(pair.a.polygon) > family_of(pair.b.polygon);
}

}  // namespace

bool takes_round(const PairCase& pair) {
  return !beyond_box2d(pair);
}

Answer collide_round(const PairCase& pair) {
  if (auto declined = beyond_box2d(pair)) return *std::move(declined);
  const bool swapped = is_swapped(pair);
  const Body& first = swapped ? pair.b : pair.a;
  const Body& second = swapped ? pair.a : pair.b;
  b2Manifold found;
  collide_by_family(found, standing(first), standing(second));
  if (found.pointCount == 0) return Manifold<double>{};

  b2WorldManifold world;
  world.Initialize(&found, to_box2d(first.pose), first.polygon.radius, to_box2d(second.pose),
                   second.polygon.radius);
  const auto wide = [](const b2Vec2& v) {
    return Vector2<double>(static_cast<double>(v.x), static_cast<double>(v.y));
  };
  const Vector2<double> towards_second = wide(world.normal);
  Manifold<double> manifold;
  manifold.count = found.pointCount;
  manifold.reference = swapped == (found.type == b2Manifold::e_faceB) ? Side::a : Side::b;
  manifold.normal = local_normal(pair, swapped ? Vector2<double>(-towards_second) : towards_second);
  for (int i = 0; i < manifold.count; ++i) {
    // Midway between both surfaces; the second's is half of the separation farther.
    const auto separation = static_cast<double>(world.separations[i]);
    const Vector2<double> on_second = wide(world.points[i]) + separation / 2 * towards_second;
    manifold.points[i] = {to_local(pair.a.pose, on_second), std::max(0.0, -separation),
                          FeaturePair{}};
  }
  order_points(manifold);
  return manifold;
}

namespace {

/// A pair as its users hold it, and what they get.
struct Prepared {
  Standing first;
  Standing second;
  float radius_of_first = 0;
  float radius_of_second = 0;
  b2Manifold found{};
  b2WorldManifold world{};
};

std::shared_ptr<std::vector<Prepared>> prepared(std::span<const PairCase> pairs) {
  const auto all = std::make_shared<std::vector<Prepared>>();
  for (const PairCase& pair : pairs) {
    const bool swapped = is_swapped(pair);
    const Body& first = swapped ? pair.b : pair.a;
    const Body& second = swapped ? pair.a : pair.b;
    all->push_back(
        {standing(first), standing(second), first.polygon.radius, second.polygon.radius});
  }
  return all;
}

}  // namespace

std::function<void()> round_pass(std::span<const PairCase> pairs) {
  return [all = prepared(pairs)] {
    for (Prepared& pair : *all) collide_by_family(pair.found, pair.first, pair.second);
  };
}

std::function<void()> world_pass(std::span<const PairCase> pairs) {
  return [all = prepared(pairs)] {
    for (Prepared& pair : *all) {
      collide_by_family(pair.found, pair.first, pair.second);
      if (pair.found.pointCount == 0) continue;
      pair.world.Initialize(&pair.found, pair.first.transform, pair.radius_of_first,
                            pair.second.transform, pair.radius_of_second);
    }
  };
}

}  // namespace manifuzz::box2d
