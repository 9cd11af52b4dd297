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

constexpr const char* kSnippet = R"(@language cpp
@point point $p, distance $s
#include <chipmunk/chipmunk.h>
#include <cstdio>

int main() {
  cpBody* body = cpBodyNew(1, 1);
@each @*.circle?   cpShape* @* = cpCircleShapeNew(body, @*.wide_radius@, @*.vertices(cpv($X, $Y))@);
@each @*.segment?   cpShape* @* = cpSegmentShapeNew(body, @*.vertices(cpv($X, $Y))@, @*.wide_radius@);
@each @*.polygon?   const cpVect of@^[] = {@*.vertices({$X, $Y})@};
@each @*.polygon?   cpShape* @* = cpPolyShapeNewRaw(body, @*.count@, of@^, @*.wide_radius@);
@each @!*.placed?   cpShapeUpdate(@*, cpTransformIdentity);
@each @*.placed?   cpShapeUpdate(@*, cpTransformNew(@*.rotation($X, $Y, -1 * $Y, $X)@, @*.position($X, $Y)@));
  const cpContactPointSet set = @asked(cpShapesCollide)@(a, b);
  std::printf("%d points, normal (%.17g, %.17g)\n", set.count, set.normal.x, set.normal.y);
  for (int i = 0; i < set.count; ++i) {
    const auto [on_a, on_b, distance] = set.points[i];
    std::printf("(%.17g, %.17g), (%.17g, %.17g), %.17g\n", on_a.x, on_a.y, on_b.x, on_b.y, distance);
  }
}
)";

/// How far from parallel, as a sine, a face may be to be the one that the normal was taken from.
constexpr double kParallel = 1e-9;

/// What segments ask for their rotation, of use with tangents alone, which these do not have.
cpBody* body_of_all() {
  static cpBody body;
  static const cpBody* const made = cpBodyInit(&body, 1, 1);
  static_cast<void>(made);
  return &body;
}

/// A shape of Chipmunk's that frees what it allocates, which polygons do beyond six vertices.
class Shape {
 public:
  explicit Shape(const manifuzz_body& body) {
    std::array<cpVect, MANIFUZZ_VERTICES_MAX> vertices;
    for (int i = 0; i < body.count; ++i) {
      vertices[i] =
          cpv(static_cast<double>(body.vertices[i].x), static_cast<double>(body.vertices[i].y));
    }
    const auto radius = static_cast<double>(body.radius);
    if (body.count == 1) {
      cpCircleShapeInit(&any_.circle, body_of_all(), radius, vertices[0]);
    } else if (body.count == 2) {
      cpSegmentShapeInit(&any_.segment, body_of_all(), vertices[0], vertices[1], radius);
    } else {
      cpPolyShapeInitRaw(&any_.polygon, body_of_all(), body.count, vertices.data(), radius);
    }
    const double cos = static_cast<double>(body.rotation.x);
    const double sin = static_cast<double>(body.rotation.y);
    cpShapeUpdate(shape(), cpTransformNew(cos, sin, -sin, cos, static_cast<double>(body.position.x),
                                          static_cast<double>(body.position.y)));
  }
  ~Shape() { cpShapeDestroy(shape()); }
  Shape& operator=(Shape&&) = delete;  // neither moved nor copied

  cpShape* shape() { return &any_.polygon.shape; }

  /// The sine of the angle between `normal` and the nearest of the faces' outward normals,
  /// of a polygon.
  double apart_from(cpVect normal) const {
    const cpPolyShape& polygon = any_.polygon;
    double least = 2;
    for (int i = 0; i < polygon.count; ++i) {
      const cpVect from = polygon.planes[i].v0;
      const cpVect to = polygon.planes[(i + 1) % polygon.count].v0;
      const cpVect outward = cpvnormalize(cpvrperp(cpvsub(to, from)));
      if (cpvdot(outward, normal) > 0) {
        least = std::min(least, std::abs(cpvcross(outward, normal)));
      }
    }
    return least;
  }

 private:
  /// Each begins with what all shapes have.
  union Any {
    cpCircleShape circle;
    cpSegmentShape segment;
    cpPolyShape polygon;
  };
  Any any_;
};

/// Chipmunk does not say whose face is the reference; its normal, A to B, tells.
manifuzz_reference reference_of(const Shape& a, const Shape& b, cpVect normal) {
  const double apart_from_a = a.apart_from(normal);
  const double apart_from_b = b.apart_from(cpvneg(normal));
  if (std::min(apart_from_a, apart_from_b) > kParallel) return MANIFUZZ_NO_REFERENCE;
  return apart_from_a <= apart_from_b ? MANIFUZZ_A : MANIFUZZ_B;
}

bool is_round(const manifuzz_body& body) {
  return body.count < 3 || body.round != 0;
}

manifuzz_double2 to_double2(cpVect v) {
  return {v.x, v.y};
}

/// Circles, segments and polygons with round corners too.
constexpr manifuzz_claims kClaims = [] {
  manifuzz_claims claims{};
  claims.vertices_min = 1;
  claims.takes_round = 1;
  return claims;
}();

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
    .claims = kClaims,
};

int manifuzz_collide(const manifuzz_body* body_a, const manifuzz_body* body_b,
                     manifuzz_manifold* manifold) {
  Shape a(*body_a);
  Shape b(*body_b);
  const cpContactPointSet set = cpShapesCollide(a.shape(), b.shape());
  manifold->count = set.count;
  if (set.count == 0) return 0;
  manifold->normal = to_double2(set.normal);
  // Round shapes touch where they are nearest: no face is the reference.
  const manifuzz_reference reference = is_round(*body_a) || is_round(*body_b)
                                           ? MANIFUZZ_NO_REFERENCE
                                           : reference_of(a, b, set.normal);
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
