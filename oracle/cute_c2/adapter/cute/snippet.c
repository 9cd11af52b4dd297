@language c
@point contact_points $p, depths $d
#define CUTE_C2_IMPLEMENTATION
#include "cute_c2.h"
#include <stdio.h>
int main(void) {
@each   c2x at@^ = {@*.position({$x, $y})@, @*.rotation({$x, $y})@};
@each @*.circle?   c2Circle @* = {c2Mulxv(at@^, @*.vertices(c2V($x, $y))@), @*.radius@};
@each @*.circle?   C2_TYPE kind@^ = C2_TYPE_CIRCLE;
@each @*.segment?   c2Capsule @* = {@*.vertices(c2Mulxv(at@^, c2V($x, $y)))@, @*.radius@};
@each @*.segment?   C2_TYPE kind@^ = C2_TYPE_CAPSULE;
@each @*.polygon?   c2Poly @* = {@*.count@, {@*.vertices({$x, $y})@}, // c2MakePoly would weld vertices
@each @*.polygon?     {@*.normals({$x, $y})@}};
@each @*.polygon?   C2_TYPE kind@^ = C2_TYPE_POLY;
  c2Manifold m;
  @asked(c2Collide)@(&a, &atA, kindA, &b, &atB, kindB, &m);
  printf("%d points, normal (%.9g, %.9g)\n", m.count, m.n.x, m.n.y);
  for (int i = 0; i < m.count; ++i)
    printf("(%.9g, %.9g) %.9g\n", m.contact_points[i].x, m.contact_points[i].y, m.depths[i]);
}
