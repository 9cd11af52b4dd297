/* Your collider as a shared library that manifuzz can load: define `manifuzz_collider` and
   `manifuzz_collide`, then `manifuzz fuzz --subject ./libmine.so`. C or C++, nothing to link. */
#ifndef MANIFUZZ_COLLIDER_H
#define MANIFUZZ_COLLIDER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { MANIFUZZ_INTERFACE = 1, MANIFUZZ_VERTICES_MAX = 8 };

typedef struct { float x, y; } manifuzz_float2;
typedef struct { double x, y; } manifuzz_double2;

/* A strictly convex polygon, counter-clockwise, swept by a disc: world = R vertex + position. */
typedef struct {
  int32_t count; /* 3 to 8 */
  manifuzz_float2 vertices[MANIFUZZ_VERTICES_MAX];
  manifuzz_float2 normals[MANIFUZZ_VERTICES_MAX]; /* of the face from vertex i to i + 1, outward */
  float radius;
  manifuzz_float2 position;
  manifuzz_float2 rotation; /* (cos, sin), R = {{cos, -sin}, {sin, cos}} */
} manifuzz_body;

typedef enum { MANIFUZZ_UNSAID = 0, MANIFUZZ_VERTEX, MANIFUZZ_FACE } manifuzz_feature_kind;
typedef struct { uint8_t kind, index; } manifuzz_feature; /* MANIFUZZ_UNSAID where you have none */

typedef struct {
  manifuzz_double2 position; /* a world point, or in A's frame: as declared */
  double depth;              /* total radius - separation, >= 0 */
  manifuzz_feature feature_a, feature_b;
} manifuzz_point;

typedef enum { MANIFUZZ_NO_REFERENCE = 0, MANIFUZZ_A, MANIFUZZ_B } manifuzz_reference;

typedef struct {
  int32_t count;    /* 0 to 2; with 0 nothing else is read */
  int32_t reference; /* whose face it is, a manifuzz_reference, if you know */
  manifuzz_double2 normal; /* unit, in the frame of the points */
  manifuzz_point points[2];
} manifuzz_manifold;

typedef enum { MANIFUZZ_FLOAT32 = 0, MANIFUZZ_FLOAT64 } manifuzz_scalar;
typedef enum { MANIFUZZ_WORLD = 0, MANIFUZZ_FRAME_OF_A } manifuzz_frame;
typedef enum { MANIFUZZ_CLIP_POINTS = 0, MANIFUZZ_MIDPOINTS } manifuzz_points;
typedef enum { MANIFUZZ_A_TO_B = 0, MANIFUZZ_B_TO_A } manifuzz_direction;

/* What the collider says of itself; it is judged by this alone. */
typedef struct {
  int32_t interface;    /* MANIFUZZ_INTERFACE */
  const char* name;     /* as tables and the corpus have it */
  const char* version;
  int32_t scalar;       /* manifuzz_scalar: what it computes in */
  int32_t rounds_in;    /* manifuzz_frame: world coordinates lose figures far from the origin */
  int32_t answers_in;   /* manifuzz_frame: of points and normal */
  int32_t points;       /* on the incident edge, or halfway between both surfaces */
  int32_t normal;       /* manifuzz_direction */
  double tie_bias;      /* B's face is the reference only where it leads by more; a length */
  int32_t vertices_max; /* 3 to 8: with more it is not asked */
  int32_t takes_radius; /* 0: rounded polygons are not asked */
  const char* snippet;  /* a program that shows one case (README.md), or NULL */
} manifuzz_declaration;

extern const manifuzz_declaration manifuzz_collider;

/* Returns 0, or 1 for a case it cannot take. `manifold` comes zeroed. */
int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold);

#ifdef __cplusplus
}
#endif
#endif
