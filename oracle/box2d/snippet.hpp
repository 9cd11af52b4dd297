#pragma once

namespace manifuzz::box2d {

/// A program that shows one case, of any shapes that Box2D takes; report/upstream fills it in.
inline constexpr const char* kSnippet = R"(@language cpp
@point world.points $m, separations $s
#include <box2d/box2d.h>
#include <algorithm>
#include <cstdio>
int main() {
@each @*.circle?   b2CircleShape @*;
@each @*.circle?   @*.m_p.Set(@*.vertices($x, $y)@);
@each @*.segment?   b2EdgeShape @*;
@each @*.segment?   @*.SetTwoSided(@*.vertices(b2Vec2($x, $y))@);
@each @*.polygon?   b2PolygonShape @*; @*.m_count = @*.count@; @*.m_radius = @*.radius@;  // Set would weld vertices
@each @*.polygon?   const b2Vec2 of@^[] = {@*.vertices(b2Vec2($x, $y))@}, out@^[] = {@*.normals(b2Vec2($x, $y))@};
@each @*.polygon?   std::copy_n(of@^, @*.count@, @*.m_vertices), std::copy_n(out@^, @*.count@, @*.m_normals);
@each @!*.polygon?   @*.m_radius = @*.radius@;
  b2Transform atA{b2Vec2(@a.position($x, $y)@), b2Rot(0)}, atB{b2Vec2(@b.position($x, $y)@), b2Rot(0)};
@each @*.turned?   @*.rotation(at@^.q.c = $x, at@^.q.s = $y)@;
  b2Manifold manifold; b2WorldManifold world{};
@a.polygon? @b.segment? @b_first
@a.circle? @!b.circle? @b_first
@a.polygon? @b.polygon?   @asked(b2CollidePolygons)@(&manifold, &a, atA, &b, atB);
@a.circle? @b.circle?   @asked(b2CollideCircles)@(&manifold, &a, atA, &b, atB);
@a.segment? @b.polygon?   @asked(b2CollideEdgeAndPolygon)@(&manifold, &a, atA, &b, atB);
@a.segment? @b.circle?   @asked(b2CollideEdgeAndCircle)@(&manifold, &a, atA, &b, atB);
@a.polygon? @b.circle?   @asked(b2CollidePolygonAndCircle)@(&manifold, &a, atA, &b, atB);
@a.polygon? @b.segment?   @asked(b2CollideEdgeAndPolygon)@(&manifold, &b, atB, &a, atA);
@a.circle? @b.segment?   @asked(b2CollideEdgeAndCircle)@(&manifold, &b, atB, &a, atA);
@a.circle? @b.polygon?   @asked(b2CollidePolygonAndCircle)@(&manifold, &b, atB, &a, atA);
@a.segment?   world.Initialize(&manifold, atA, a.m_radius, atB, b.m_radius);
@a.polygon? @!b.segment?   world.Initialize(&manifold, atA, a.m_radius, atB, b.m_radius);
@a.circle? @b.circle?   world.Initialize(&manifold, atA, a.m_radius, atB, b.m_radius);
@a.polygon? @b.segment?   world.Initialize(&manifold, atB, b.m_radius, atA, a.m_radius);
@a.circle? @!b.circle?   world.Initialize(&manifold, atB, b.m_radius, atA, a.m_radius);
  std::printf("%d points, normal (%.9g, %.9g)\n", manifold.pointCount, world.normal.x, world.normal.y);
  for (int i = 0; i < manifold.pointCount; ++i) std::printf("(%.9g, %.9g), %.9g\n", world.points[i].x, world.points[i].y, world.separations[i]);
}
)";

}  // namespace manifuzz::box2d
