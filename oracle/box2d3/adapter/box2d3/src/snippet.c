@language c
@point in the world $m, separation $s
@none no point of a separation of 0 or less
#include <box2d/collision.h>
#include <box2d/math_functions.h>
#include <stdio.h>
int main(void) {
@each @*.circle?   b2Circle @* = {@*.vertices({$x, $y})@, @*.radius@};
@each @*.segment? @!*.rounded?   b2Segment @* = {@*.vertices({$x, $y})@};
@each @*.segment? @*.rounded?   b2Capsule @* = {@*.vertices({$x, $y})@, @*.radius@};
@each @*.polygon?   b2Polygon @* = {.count = @*.count@, .radius = @*.radius@, // b2ComputeHull would weld vertices
@each @*.polygon?     .vertices = {@*.vertices({$x, $y})@},
@each @*.polygon?     .normals = {@*.normals({$x, $y})@}};
@each   b2Transform at@^ = {@*.position({$x, $y})@, @*.rotation({$x, $y})@};
@a.polygon? @b.segment? @!b.rounded? @b_first
@a.segment? @a.rounded? @b.segment? @!b.rounded? @b_first
@a.segment? @a.rounded? @b.polygon? @b_first
@a.circle? @b.segment? @!b.rounded? @b_first
@a.circle? @b.polygon? @b_first
@a.circle? @b.segment? @b.rounded? @b_first
@a.segment? @!a.rounded? @b.segment? @!b.rounded?   b2Capsule of = {b.point1, b.point2, 0};
@a.segment? @!a.rounded? @b.segment? @!b.rounded?   b2LocalManifold m = @asked(b2CollideSegmentAndCapsule)@(&a, &of, b2InvMulTransforms(atA, atB));
@a.segment? @!a.rounded? @b.polygon?   b2LocalManifold m = @asked(b2CollideSegmentAndPolygon)@(&a, &b, b2InvMulTransforms(atA, atB));
@a.segment? @!a.rounded? @b.segment? @b.rounded?   b2LocalManifold m = @asked(b2CollideSegmentAndCapsule)@(&a, &b, b2InvMulTransforms(atA, atB));
@a.segment? @!a.rounded? @b.circle?   b2LocalManifold m = @asked(b2CollideSegmentAndCircle)@(&a, &b, b2InvMulTransforms(atA, atB));
@a.polygon? @b.segment? @!b.rounded?   b2LocalManifold m = @asked(b2CollideSegmentAndPolygon)@(&b, &a, b2InvMulTransforms(atB, atA));
@a.polygon? @b.polygon?   b2LocalManifold m = @asked(b2CollidePolygons)@(&a, &b, b2InvMulTransforms(atA, atB));
@a.polygon? @b.segment? @b.rounded?   b2LocalManifold m = @asked(b2CollidePolygonAndCapsule)@(&a, &b, b2InvMulTransforms(atA, atB));
@a.polygon? @b.circle?   b2LocalManifold m = @asked(b2CollidePolygonAndCircle)@(&a, &b, b2InvMulTransforms(atA, atB));
@a.segment? @a.rounded? @b.segment? @!b.rounded?   b2LocalManifold m = @asked(b2CollideSegmentAndCapsule)@(&b, &a, b2InvMulTransforms(atB, atA));
@a.segment? @a.rounded? @b.polygon?   b2LocalManifold m = @asked(b2CollidePolygonAndCapsule)@(&b, &a, b2InvMulTransforms(atB, atA));
@a.segment? @a.rounded? @b.segment? @b.rounded?   b2LocalManifold m = @asked(b2CollideCapsules)@(&a, &b, b2InvMulTransforms(atA, atB));
@a.segment? @a.rounded? @b.circle?   b2LocalManifold m = @asked(b2CollideCapsuleAndCircle)@(&a, &b, b2InvMulTransforms(atA, atB));
@a.circle? @b.segment? @!b.rounded?   b2LocalManifold m = @asked(b2CollideSegmentAndCircle)@(&b, &a, b2InvMulTransforms(atB, atA));
@a.circle? @b.polygon?   b2LocalManifold m = @asked(b2CollidePolygonAndCircle)@(&b, &a, b2InvMulTransforms(atB, atA));
@a.circle? @b.segment? @b.rounded?   b2LocalManifold m = @asked(b2CollideCapsuleAndCircle)@(&b, &a, b2InvMulTransforms(atB, atA));
@a.circle? @b.circle?   b2LocalManifold m = @asked(b2CollideCircles)@(&a, &b, b2InvMulTransforms(atA, atB));
  printf("%d points, normal (%.9g, %.9g)\n", m.pointCount, m.normal.x, m.normal.y);
  for (int i = 0; i < m.pointCount; ++i) // in the first shape's frame
    printf("(%.9g, %.9g) %.9g\n", m.points[i].point.x, m.points[i].point.y, m.points[i].separation);
}
