#pragma once

namespace manifuzz::box2d {

/// A program that shows one case, of any shapes that Box2D takes; report/upstream.cpp fills it in.
inline constexpr const char* kSnippet = R"(#include <box2d/box2d.h>
#include <cstdio>
#include <type_traits>

template <int count>
auto shape(const b2Vec2 (&vertices)[count], const b2Vec2 (&normals)[count], float radius) {
  if constexpr (count == 1) {
    b2CircleShape circle;
    circle.m_p = vertices[0];
    circle.m_radius = radius;
    return circle;
  } else if constexpr (count == 2) {
    b2EdgeShape edge;
    edge.SetTwoSided(vertices[0], vertices[1]);
    edge.m_radius = radius;
    return edge;
  } else {
    b2PolygonShape polygon;  // filled as it stands: Set would weld and reorder
    for (int i = 0; i < count; ++i) {
      polygon.m_vertices[i] = vertices[i];
      polygon.m_normals[i] = normals[i];
    }
    polygon.m_count = count;
    polygon.m_radius = radius;
    return polygon;
  }
}

b2Transform pose(b2Vec2 position, b2Vec2 rotation) {
  b2Transform transform;
  transform.p = position;
  transform.q.c = rotation.x;
  transform.q.s = rotation.y;
  return transform;
}

template <class A, class B>
void show(const A& a, const b2Transform& pose_a, const B& b, const b2Transform& pose_b) {
  constexpr bool edge_a = std::is_same_v<A, b2EdgeShape>, edge_b = std::is_same_v<B, b2EdgeShape>;
  constexpr bool circle_a = std::is_same_v<A, b2CircleShape>;
  constexpr bool circle_b = std::is_same_v<B, b2CircleShape>;
  b2Manifold manifold;
  if constexpr ((circle_a && !circle_b) || (edge_b && !edge_a)) {
    std::printf("B first: edges, then polygons, then circles\n");
    return show(b, pose_b, a, pose_a);
  } else if constexpr (circle_a) {
    b2CollideCircles(&manifold, &a, pose_a, &b, pose_b);
  } else if constexpr (edge_a && circle_b) {
    b2CollideEdgeAndCircle(&manifold, &a, pose_a, &b, pose_b);
  } else if constexpr (edge_a) {
    b2CollideEdgeAndPolygon(&manifold, &a, pose_a, &b, pose_b);
  } else if constexpr (circle_b) {
    b2CollidePolygonAndCircle(&manifold, &a, pose_a, &b, pose_b);
  } else {
    b2CollidePolygons(&manifold, &a, pose_a, &b, pose_b);
  }
  std::printf("%d points\n", manifold.pointCount);
  b2WorldManifold world;
  world.Initialize(&manifold, pose_a, a.m_radius, pose_b, b.m_radius);
  for (int i = 0; i < manifold.pointCount; ++i) {
    std::printf("(%.9g, %.9g), separation %.9g\n", world.points[i].x, world.points[i].y,
                world.separations[i]);
  }
}

int main() {
  const auto a = shape<@a.count@>(@a.vertices{}@, @a.normals{}@, @a.radius@);
  const auto b = shape<@b.count@>(@b.vertices{}@, @b.normals{}@, @b.radius@);
  show(a, pose(@a.position{}@, @a.rotation{}@), b, pose(@b.position{}@, @b.rotation{}@));
}
)";

}  // namespace manifuzz::box2d
