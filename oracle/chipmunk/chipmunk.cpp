// Chipmunk's cpShapesCollide for manifuzz, polygon against polygon:
//
//   g++ -std=c++20 -O2 -shared -fPIC chipmunk.cpp -lchipmunk -o libmanifuzz_chipmunk.so
//   manifuzz fuzz --subject ./libmanifuzz_chipmunk.so

#include <algorithm>
#include <array>
#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>
#include <cmath>

#include "manifuzz_collider.h"

namespace {

constexpr const char* kSnippet = R"(#include <cstdio>
#include <chipmunk/chipmunk.h>

struct Point { float x, y; };

template <int count>
cpShape* make(const Point (&vertices)[count], Point position, Point rotation) {
  cpVect wide[count];
  for (int i = 0; i < count; ++i) wide[i] = cpv(vertices[i].x, vertices[i].y);
  cpShape* shape = cpPolyShapeNewRaw(nullptr, count, wide, 0);
  const double c = rotation.x, s = rotation.y;
  cpShapeUpdate(shape, cpTransformNew(c, s, -s, c, position.x, position.y));
  return shape;
}

int main() {
  cpShape* a = make<@a.count@>(@a.vertices{}@, @a.position{}@, @a.rotation{}@);
  cpShape* b = make<@b.count@>(@b.vertices{}@, @b.position{}@, @b.rotation{}@);
  const cpContactPointSet set = cpShapesCollide(a, b);
  std::printf("%d points, normal (%.17g, %.17g)\n", set.count, set.normal.x, set.normal.y);
  for (int i = 0; i < set.count; ++i) {
    const auto [on_a, on_b, distance] = set.points[i];
    std::printf("(%.17g, %.17g) on A, (%.17g, %.17g) on B, distance %.17g\n", on_a.x, on_a.y,
                on_b.x, on_b.y, distance);
  }
}
)";

/// How far from parallel, as a sine, a face may be to be the one that the normal was taken from.
constexpr double kParallel = 1e-9;

/// A polygon of Chipmunk's that frees what it allocates, which it does beyond six vertices.
class Polygon {
 public:
  explicit Polygon(const manifuzz_body& body) {
    std::array<cpVect, MANIFUZZ_VERTICES_MAX> vertices;
    for (int i = 0; i < body.count; ++i) {
      vertices[i] =
          cpv(static_cast<double>(body.vertices[i].x), static_cast<double>(body.vertices[i].y));
    }
    cpPolyShapeInitRaw(&polygon_, nullptr, body.count, vertices.data(), 0);
    const double cos = static_cast<double>(body.rotation.x);
    const double sin = static_cast<double>(body.rotation.y);
    cpShapeUpdate(shape(), cpTransformNew(cos, sin, -sin, cos, static_cast<double>(body.position.x),
                                          static_cast<double>(body.position.y)));
  }
  ~Polygon() { cpShapeDestroy(shape()); }
  Polygon& operator=(Polygon&&) = delete;  // neither moved nor copied

  cpShape* shape() { return &polygon_.shape; }

  /// The sine of the angle between `normal` and the nearest of the faces' outward normals.
  double apart_from(cpVect normal) const {
    double least = 2;
    for (int i = 0; i < polygon_.count; ++i) {
      const cpVect from = polygon_.planes[i].v0;
      const cpVect to = polygon_.planes[(i + 1) % polygon_.count].v0;
      const cpVect outward = cpvnormalize(cpvrperp(cpvsub(to, from)));
      if (cpvdot(outward, normal) > 0) {
        least = std::min(least, std::abs(cpvcross(outward, normal)));
      }
    }
    return least;
  }

 private:
  cpPolyShape polygon_;
};

/// Chipmunk does not say whose face is the reference; its normal, A to B, tells.
manifuzz_reference reference_of(const Polygon& a, const Polygon& b, cpVect normal) {
  const double apart_from_a = a.apart_from(normal);
  const double apart_from_b = b.apart_from(cpvneg(normal));
  if (std::min(apart_from_a, apart_from_b) > kParallel) return MANIFUZZ_NO_REFERENCE;
  return apart_from_a <= apart_from_b ? MANIFUZZ_A : MANIFUZZ_B;
}

manifuzz_double2 to_double2(cpVect v) {
  return {v.x, v.y};
}

}  // namespace

extern "C" {

extern const manifuzz_declaration manifuzz_collider = {
    .interface = MANIFUZZ_INTERFACE,
    .name = "chipmunk",
    .version = cpVersionString,
    .scalar = MANIFUZZ_FLOAT64,
    .rounds_in = MANIFUZZ_WORLD,
    .answers_in = MANIFUZZ_WORLD,
    .points = MANIFUZZ_CLIP_POINTS,
    .normal = MANIFUZZ_A_TO_B,
    .tie_bias = 0,
    .vertices_max = MANIFUZZ_VERTICES_MAX,
    .takes_radius = 0,
    .snippet = kSnippet,
    .claims = {},
};

int manifuzz_collide(const manifuzz_body* body_a, const manifuzz_body* body_b,
                     manifuzz_manifold* manifold) {
  Polygon a(*body_a);
  Polygon b(*body_b);
  const cpContactPointSet set = cpShapesCollide(a.shape(), b.shape());
  manifold->count = set.count;
  if (set.count == 0) return 0;
  manifold->normal = to_double2(set.normal);
  const manifuzz_reference reference = reference_of(a, b, set.normal);
  manifold->reference = reference;
  for (int i = 0; i < set.count; ++i) {
    // Each point is there twice, on either polygon's edge: the incident edge's is the clip point.
    const cpVect clipped = reference == MANIFUZZ_B ? set.points[i].pointA : set.points[i].pointB;
    manifold->points[i].position = to_double2(clipped);
    manifold->points[i].depth = std::max(-set.points[i].distance, 0.0);
  }
  return 0;
}

}  // extern "C"
