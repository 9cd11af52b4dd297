/* Your collider as a shared library that manifuzz can load: define `manifuzz_collider` and
   `manifuzz_collide`, then `manifuzz fuzz --subject ./libmine.so`. C or C++, nothing to link. */
#ifndef MANIFUZZ_COLLIDER_H
#define MANIFUZZ_COLLIDER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { MANIFUZZ_INTERFACE = 5, MANIFUZZ_VERTICES_MAX = 8 };

typedef struct { float x, y; } manifuzz_float2;
typedef struct { double x, y; } manifuzz_double2;

/* A strictly convex polygon, counter-clockwise, or a segment (2 vertices) or a point (1), with a
   radius around it: world = R vertex + position. A segment has two faces, one a side; a point none.

   (cos, sin) is a unit vector to a float's precision only. A collider in double that takes R's
   transpose for its inverse is off by that, unless it moves the length into the vertices first:

     const double length = hypot(body->rotation.x, body->rotation.y);
     const double cosine = body->rotation.x / length, sine = body->rotation.y / length;
     for (int i = 0; i < body->count; ++i) {
       vertices[i] = (vector){length * body->vertices[i].x, length * body->vertices[i].y};
     }
*/
typedef struct {
  int32_t count; /* `vertices_min` to `vertices_max` of the declaration */
  manifuzz_float2 vertices[MANIFUZZ_VERTICES_MAX];
  manifuzz_float2 normals[MANIFUZZ_VERTICES_MAX]; /* of the face from vertex i to i + 1, outward */
  float radius;
  manifuzz_float2 position;
  manifuzz_float2 rotation; /* (cos, sin), R = {{cos, -sin}, {sin, cos}} */
  /* From interface 3 on. */
  int32_t round; /* 1: corners are round, as they are of segments and points; 0: mitred */
  /* From interface 5 on: the normals in double, of the vertices as they are. */
  manifuzz_double2 normals_double[MANIFUZZ_VERTICES_MAX];
} manifuzz_body;

typedef enum { MANIFUZZ_UNSAID = 0, MANIFUZZ_VERTEX, MANIFUZZ_FACE } manifuzz_feature_kind;
typedef struct { uint8_t kind, index; } manifuzz_feature; /* MANIFUZZ_UNSAID where you have none */

typedef struct {
  manifuzz_double2 position; /* a world point, or in A's frame: as declared */
  double depth;              /* total radius - separation, >= 0 */
  manifuzz_feature feature_a, feature_b;
} manifuzz_point;

typedef enum { MANIFUZZ_NO_REFERENCE = 0, MANIFUZZ_A, MANIFUZZ_B } manifuzz_reference;

/* What you made of a polygon, in its own frame. */
typedef struct {
  int32_t count; /* 1 to 8, or 0: nothing is said */
  manifuzz_double2 vertices[MANIFUZZ_VERTICES_MAX];
} manifuzz_shape;

typedef struct {
  int32_t count;    /* of points: 0 to 2 */
  int32_t reference; /* whose face it is, a manifuzz_reference, if you know */
  manifuzz_double2 normal; /* unit, in the frame of the points */
  manifuzz_point points[2];
  /* From interface 2 on. */
  int32_t touching; /* where you claim less than points: 1 or 0 */
  double depth;     /* along the normal, where you claim a separation; negative across a gap */
  manifuzz_shape shapes[2]; /* A's, B's: where you alter them */
} manifuzz_manifold;

typedef enum { MANIFUZZ_FLOAT32 = 0, MANIFUZZ_FLOAT64 } manifuzz_scalar;
typedef enum { MANIFUZZ_WORLD = 0, MANIFUZZ_FRAME_OF_A } manifuzz_frame;
typedef enum {
  MANIFUZZ_CLIP_POINTS = 0,
  MANIFUZZ_MIDPOINTS,
  MANIFUZZ_AT_VERTICES,
  MANIFUZZ_ON_SURFACE_A,
  MANIFUZZ_ON_SURFACE_B
} manifuzz_points;
typedef enum { MANIFUZZ_A_TO_B = 0, MANIFUZZ_B_TO_A } manifuzz_direction;

typedef enum {
  MANIFUZZ_CLAIMS_MANIFOLD = 0,
  MANIFUZZ_CLAIMS_POINT,      /* at most one */
  MANIFUZZ_CLAIMS_SEPARATION, /* touching, normal and depth */
  MANIFUZZ_CLAIMS_TOUCHING    /* touching alone */
} manifuzz_claim;

typedef enum {
  MANIFUZZ_SECOND_POINT_BY_CLIP = 0, /* where the clip of two edges keeps one */
  MANIFUZZ_SECOND_POINT_NEVER,
  MANIFUZZ_SECOND_POINT_WITHIN_ANGLE /* of both edges' normals and the contact's */
} manifuzz_second_point;

/* Where it takes a face's normal from. */
typedef enum {
  MANIFUZZ_NORMALS_GIVEN = 0,   /* the body's */
  MANIFUZZ_NORMALS_OF_VERTICES, /* from the body's vertices */
  MANIFUZZ_NORMALS_OF_WORLD_VERTICES /* from vertices that were rounded in the world */
} manifuzz_normals;

/* What its answers claim; README.md says what each means. All zero: manifolds that clips make. */
typedef struct {
  int32_t answers;          /* manifuzz_claim */
  int32_t does_not_clip;    /* 1: no reference face is meant */
  int32_t shares_depth;     /* 1: all points have the deepest's */
  int32_t one_point_enough;
  int32_t takes_angles;     /* 1: rotations reach it as angles */
  int32_t alters_shapes;    /* 1: it fills in `shapes` */
  double speculative;       /* a length */
  double least_depth;       /* a length */
  double tie_bias_relative; /* of the favoured side's separation */
  int32_t tie_bias_towards; /* manifuzz_reference; A where none is named */
  double tolerance_absolute;
  double tolerance_relative;
  const char* tolerance_source; /* where it is documented, or NULL */
  /* From interface 3 on. */
  int32_t vertices_min; /* 1: circles too; 2: segments and capsules too; 3, or 0: polygons alone */
  int32_t takes_round;  /* 1: polygons with round corners too */
  int32_t second_point; /* of round shapes, a manifuzz_second_point */
  double second_point_angle; /* in radians */
  /* From interface 4 on, 0: any. Polygons of which fewer than three corners turn by more (radians,
   * below pi / 2), or of less area, are not asked. */
  double least_polygon_turn;
  double least_polygon_area;
  int32_t normals; /* a manifuzz_normals; from interface 5 on */
} manifuzz_claims;

/* What the collider says of itself; it is judged by this alone. */
typedef struct {
  int32_t interface;    /* MANIFUZZ_INTERFACE; of earlier ones, what later ones added is not read */
  const char* name;     /* as tables and the corpus have it */
  const char* version;
  int32_t scalar;       /* manifuzz_scalar: what it computes in */
  int32_t rounds_in;    /* manifuzz_frame: world coordinates lose figures far from the origin */
  int32_t answers_in;   /* manifuzz_frame: of points and normal */
  int32_t points;       /* on the incident edge, or halfway between both surfaces */
  int32_t normal;       /* manifuzz_direction */
  double tie_bias;      /* B's face is the reference only where it leads by more; a length */
  int32_t vertices_max; /* 3 to 8: with more it is not asked */
  int32_t takes_radius; /* 0: mitred polygons with radii are not asked */
  const char* snippet;  /* a program that shows one case (README.md), or NULL */
  manifuzz_claims claims; /* from interface 2 on */
} manifuzz_declaration;

extern const manifuzz_declaration manifuzz_collider;

/* Returns 0, or 1 for a case it cannot take. `manifold` comes zeroed. */
int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold);

#ifdef __cplusplus
}
#endif
#endif
