/* The article's clipping in C as a shared library, to start from; put your engine into
   `manifuzz_collide`, and what it is into `manifuzz_collider`:

     cc -O2 -shared -fPIC -I FOLDER_OF_THE_HEADER clip.c -o libclip.so -lm */
#include <math.h>
#include <stdlib.h>

#include "manifuzz_collider.h"

const manifuzz_declaration manifuzz_collider = {
    .interface = MANIFUZZ_INTERFACE,
    .name = "clip-c",
    .version = "1",
    .scalar = MANIFUZZ_FLOAT64,
    .rounds_in = MANIFUZZ_FRAME_OF_A,
    .answers_in = MANIFUZZ_FRAME_OF_A,
    .vertices_max = MANIFUZZ_VERTICES_MAX,
    .takes_radius = 1,
};

typedef manifuzz_double2 vector;

static double dot(vector p, vector q) { return p.x * q.x + p.y * q.y; }
static vector minus(vector p, vector q) { return (vector){p.x - q.x, p.y - q.y}; }
static vector turn(manifuzz_float2 r, vector v) {
  return (vector){r.x * v.x - r.y * v.y, r.y * v.x + r.x * v.y};
}

/* Corners turned and moved into the world, whose origin is A's position: it is subtracted first, so
   that distance from the origin costs nothing. */
typedef struct {
  int count;
  vector corners[MANIFUZZ_VERTICES_MAX];
  vector normals[MANIFUZZ_VERTICES_MAX];
} shape;

static shape placed(const manifuzz_body *body, manifuzz_float2 origin) {
  const vector offset = {(double)body->position.x - origin.x, (double)body->position.y - origin.y};
  const double length = hypot(body->rotation.x, body->rotation.y);
  shape s = {.count = body->count};
  for (int i = 0; i < s.count; ++i) {
    const vector v = turn(body->rotation, (vector){body->vertices[i].x, body->vertices[i].y});
    const vector n = turn(body->rotation, body->normals_double[i]);
    s.corners[i] = (vector){v.x + offset.x, v.y + offset.y};
    s.normals[i] = (vector){n.x / length, n.y / length};
  }
  return s;
}

typedef struct {
  double separation;
  int of_b, index;
} face;

static face face_of(const shape *s, int index, const shape *opposing, int of_b) {
  double least = INFINITY;
  for (int i = 0; i < opposing->count; ++i)
    least = fmin(least, dot(s->normals[index], minus(opposing->corners[i], s->corners[index])));
  return (face){least, of_b, index};
}

/* The greatest separation first; of equal ones A's, then the lower index. */
static int by_separation(const void *p, const void *q) {
  const face *one = p, *other = q;
  if (one->separation != other->separation) return one->separation < other->separation ? 1 : -1;
  return one->of_b != other->of_b ? one->of_b - other->of_b : one->index - other->index;
}

/* The incident edge, between the face's side planes and behind it; how many points there are. */
static int clip(int index, const shape *reference, const shape *opposing, double radius,
                vector points[2], double depths[2]) {
  const vector normal = reference->normals[index], tangent = {-normal.y, normal.x};
  const vector ends[2] = {reference->corners[index],
                          reference->corners[(index + 1) % reference->count]};
  int incident = 0, count = 0;
  for (int i = 1; i < opposing->count; ++i)
    if (dot(opposing->normals[i], normal) < dot(opposing->normals[incident], normal)) incident = i;
  vector edge[2] = {opposing->corners[(incident + 1) % opposing->count],
                    opposing->corners[incident]}; /* in the direction of the reference face */
  for (int i = 0; i < 2; ++i) {
    const double sign = i == 0 ? 1 : -1;
    const double here = sign * dot(tangent, minus(edge[i], ends[i])) + radius;
    const double there = sign * dot(tangent, minus(edge[1 - i], ends[i])) + radius;
    if (here < 0 && there < 0) return 0;
    if (here < 0) {
      const vector along = minus(edge[1 - i], edge[i]);
      const double share = here / (here - there);
      edge[i] = (vector){edge[i].x + share * along.x, edge[i].y + share * along.y};
    }
  }
  for (int i = 0; i < 2; ++i) {
    const double depth = radius - dot(normal, minus(edge[i], ends[0]));
    if (depth < 0) continue;
    points[count] = edge[i];
    depths[count++] = depth;
  }
  return count;
}

int manifuzz_collide(const manifuzz_body *body_a, const manifuzz_body *body_b,
                     manifuzz_manifold *manifold) {
  const shape a = placed(body_a, body_a->position), b = placed(body_b, body_a->position);
  const double radius = (double)body_a->radius + body_b->radius;
  face faces[2 * MANIFUZZ_VERTICES_MAX];
  double reach = 0, depths[2];
  vector points[2];
  int count = 0, tried = 0;
  for (int i = 0; i < a.count; ++i) faces[count++] = face_of(&a, i, &b, 0);
  for (int i = 0; i < b.count; ++i) faces[count++] = face_of(&b, i, &a, 1);
  qsort(faces, (size_t)count, sizeof faces[0], by_separation);
  if (faces[0].separation > radius) return 0;
  for (int i = 0; i < a.count; ++i) reach = fmax(reach, fmax(fabs(a.corners[i].x), fabs(a.corners[i].y)));
  for (int i = 0; i < b.count; ++i) reach = fmax(reach, fmax(fabs(b.corners[i].x), fabs(b.corners[i].y)));
  /* The slab of a face that leads by rounding alone may miss what overlaps: the next one's then. */
  for (; tried < count && manifold->count == 0; ++tried) {
    const face *best = &faces[tried];
    manifold->count = best->of_b ? clip(best->index, &b, &a, radius, points, depths)
                                 : clip(best->index, &a, &b, radius, points, depths);
    if (faces[0].separation > -0x1p-50 * reach) {
      ++tried;
      break;
    }
  }
  if (manifold->count == 0) return 0;
  /* Into A's frame: the rotation is unit to a float's bits only, its inverse the transpose over the square. */
  const face *best = &faces[tried - 1];
  const manifuzz_float2 back = {body_a->rotation.x, -body_a->rotation.y};
  const double squared = (double)back.x * back.x + (double)back.y * back.y;
  const vector outward = turn(back, best->of_b ? b.normals[best->index] : a.normals[best->index]);
  const double sign = (best->of_b ? -1 : 1) / sqrt(squared);
  manifold->normal = (vector){sign * outward.x, sign * outward.y};
  manifold->reference = best->of_b ? MANIFUZZ_B : MANIFUZZ_A;
  for (int i = 0; i < manifold->count; ++i) {
    const vector local = turn(back, points[i]);
    manifold->points[i].position = (vector){local.x / squared, local.y / squared};
    manifold->points[i].depth = depths[i];
  }
  return 0;
}
