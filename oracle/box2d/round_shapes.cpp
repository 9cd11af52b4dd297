#include "oracle/box2d/round_shapes.hpp"

#include <algorithm>
#include <optional>

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
  return shape.count >= kMinVertices && shape.is_round() && shape.radius > 0;
}

std::optional<Unsupported> beyond_box2d(const PairCase& pair) {
  const Family a = family_of(pair.a.polygon);
  const Family b = family_of(pair.b.polygon);
  if (a == Family::circle || b == Family::circle) return std::nullopt;
  if (a == Family::edge && b == Family::edge) return Unsupported{"has no edge against edge"};
  if (has_round_corners(pair.a.polygon) || has_round_corners(pair.b.polygon)) {
    return Unsupported{"its polygons' corners are mitred"};
  }
  return std::nullopt;
}

b2Manifold found_by(const Body& first, const Body& second) {
  const b2Transform of_first = to_box2d(first.pose);
  const b2Transform of_second = to_box2d(second.pose);
  b2Manifold found;
  const bool is_circle = family_of(second.polygon) == Family::circle;
  switch (family_of(first.polygon)) {
    case Family::circle: {
      const b2CircleShape a = to_circle(first.polygon);
      const b2CircleShape b = to_circle(second.polygon);
      b2CollideCircles(&found, &a, of_first, &b, of_second);
      return found;
    }
    case Family::polygon: {
      const b2PolygonShape a = to_box2d(first.polygon);
      if (!is_circle) {
        const b2PolygonShape b = to_box2d(second.polygon);
        b2CollidePolygons(&found, &a, of_first, &b, of_second);
        return found;
      }
      const b2CircleShape b = to_circle(second.polygon);
      b2CollidePolygonAndCircle(&found, &a, of_first, &b, of_second);
      return found;
    }
    case Family::edge: {
      const b2EdgeShape a = to_edge(first.polygon);
      if (!is_circle) {
        b2PolygonShape b = to_box2d(second.polygon);
        b2CollideEdgeAndPolygon(&found, &a, of_first, &b, of_second);
        return found;
      }
      const b2CircleShape b = to_circle(second.polygon);
      b2CollideEdgeAndCircle(&found, &a, of_first, &b, of_second);
      return found;
    }
  }
  return found;
}

}  // namespace

bool takes_round(const PairCase& pair) {
  return !beyond_box2d(pair);
}

Answer collide_round(const PairCase& pair) {
  if (auto declined = beyond_box2d(pair)) return *std::move(declined);
  const bool is_swapped = family_of(pair.a.polygon) > family_of(pair.b.polygon);
  const Body& first = is_swapped ? pair.b : pair.a;
  const Body& second = is_swapped ? pair.a : pair.b;
  const b2Manifold found = found_by(first, second);
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
  manifold.reference = is_swapped == (found.type == b2Manifold::e_faceB) ? Side::a : Side::b;
  manifold.normal =
      local_normal(pair, is_swapped ? Vector2<double>(-towards_second) : towards_second);
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

}  // namespace manifuzz::box2d
