#include "methods/clip_by_gjk.hpp"
#include "methods/closest_points.hpp"
#include "methods/shrink.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

template <class Scalar>
Answer closest_points(const PairCase& pair, Scalar) {
  return own::answer_of<Scalar>(pair, [](const auto& a, const auto& b, const Pose<Scalar>& b_in_a) {
    methods::Simplex hint;
    return methods::contact_by_gjk(a, b, b_in_a, hint).manifold;
  });
}

Answer clipped(const PairCase& pair, float) {
  return own::answer_of<float>(pair, [](const auto& a, const auto& b, const Pose<float>& b_in_a) {
    methods::Simplex hint;
    return methods::clip_by_gjk(a, transform(b_in_a, b), hint);
  });
}

template <class Scalar>
Collider of_closest_points(std::string name, std::string description) {
  Collider collider = own::collider_of<Scalar>({.name = std::move(name),
                                                .version = MANIFUZZ_VERSION,
                                                .description = std::move(description),
                                                .min_vertices = 1,
                                                .takes_round = true,
                                                .claims = Claims::point},
                                               closest_points<Scalar>, nullptr);
  collider.in_double = make_gjk64;  // collider_of has clip64
  return collider;
}

/// By which part of its inradius each polygon is shrunk.
constexpr double kShrunkPart = 0.25;

/// A shape as an answer says that it was used.
UsedVertices used(const ConvexPolygon<float>& shape) {
  UsedVertices vertices;
  vertices.count = shape.count;
  for (int i = 0; i < shape.count; ++i) vertices.all[i] = shape.vertices[i].cast<double>();
  vertices.round_radius = shape.radius;
  return vertices;
}

Answer by_shrunk_shapes(const PairCase& pair, float) {
  const PairCase of_shrunk = shrunk_pair(pair);
  PartialManifold answer;
  answer.manifold = std::get<Manifold<double>>(closest_points<float>(of_shrunk, 0));
  answer.used = UsedShapes{used(of_shrunk.a.polygon), used(of_shrunk.b.polygon)};
  return answer;
}

}  // namespace

PairCase shrunk_pair(const PairCase& pair) {
  const auto shrunk = [](const ConvexPolygon<float>& polygon) {
    return methods::shrink(polygon, static_cast<float>(kShrunkPart * methods::inradius(polygon)));
  };
  return {{shrunk(pair.a.polygon), pair.a.pose}, {shrunk(pair.b.polygon), pair.b.pose}};
}

Collider make_gjk() {
  return of_closest_points<float>(
      "gjk", "closest points by GJK, and EPA where cores overlap, in float; one point");
}

Collider make_gjk64() {
  return of_closest_points<double>(
      "gjk64", "closest points by GJK, and EPA where cores overlap, in double; one point");
}

Collider make_gjk_shrunk() {
  Collider collider = own::collider_of<float>(
      {.name = "gjk-shrunk",
       .version = MANIFUZZ_VERSION,
       .description = "gjk on polygons shrunk by a quarter of their inradius, corners then round",
       .min_vertices = 1,
       .takes_round = true,
       .claims = Claims::point,
       .alters_shapes = true},
      by_shrunk_shapes, nullptr);
  collider.in_double = nullptr;
  return collider;
}

Collider make_gjk_clip() {
  return own::collider_of<float>(
      {.name = "gjk-clip",
       .version = MANIFUZZ_VERSION,
       .description = "faces by GJK and EPA, points by clipping, in float; of polygons"},
      clipped, nullptr);
}

}  // namespace manifuzz
