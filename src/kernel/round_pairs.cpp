#include "kernel/round_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "clipping/collide.hpp"

namespace manifuzz::kernel {

namespace {

/// A circle's core: all of it that its contact asks for.
ConvexPolygon<float> centre_of(const ShapeRows& rows) {
  ConvexPolygon<float> circle;
  circle.vertices[0] = {rows.x[0], rows.y[0]};
  circle.count = 1;
  circle.radius = rows.radius;
  circle.rounding = Rounding::round;
  return circle;
}

ConvexPolygon<float> placed_centre(const ShapeRows& b, const Pose<float>& b_in_a) {
  ConvexPolygon<float> placed = centre_of(b);
  placed.vertices[0] = transform(b_in_a, placed.vertices[0]);
  return placed;
}

template <class Scalar>
Scalar between_outlines(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  return static_cast<Scalar>(std::sqrt(clipping::squared_between_outlines(a, b)));
}

}  // namespace

/// Flattened: the centres stay in registers.
[[gnu::flatten]] Manifold<float> collide_circles(const ShapeRows& a, const ShapeRows& b,
                                                 const Pose<float>& b_in_a) {
  return clipping::contact_of_circles(centre_of(a), placed_centre(b, b_in_a));
}

/// By the clean code's own search: corners that lanes have placed, at the index of a face that
/// lanes have found, take longer to read than that saves.
[[gnu::flatten]] Manifold<float> collide_circle_and_core(const ShapeRows& a, const ShapeRows& b,
                                                         const Pose<float>& b_in_a) {
  if (b.count == 1) {
    alignas(64) const ConvexPolygon<float> core = polygon_of(a);  // as in contact_of_cores
    return clipping::contact_of_circle(core, placed_centre(b, b_in_a), Side::a, {});
  }
  ConvexPolygon<float> placed;
  placed.count = b.count;
  placed.radius = b.radius;
  placed.rounding = b.rounding;
  for (int i = 0; i < b.count; ++i) {
    placed.vertices[i] = transform(b_in_a, Vector2<float>(b.x[i], b.y[i]));
    placed.normals[i] = rotate(b_in_a.rotation, Vector2<float>(b.normal_x[i], b.normal_y[i]));
  }
  return clipping::contact_of_circle(centre_of(a), placed, Side::b, {});
}

/// Polygons are aligned: what is written as vectors is read back at once.
[[gnu::flatten]] Manifold<float> contact_of_cores(const ShapeRows& a, const ShapeRows& b_in_a,
                                                  const int (&face)[2], float tie_bias) {
  alignas(64) const ConvexPolygon<float> polygon_a = polygon_of(a);
  alignas(64) const ConvexPolygon<float> polygon_b = polygon_of(b_in_a);
  return clipping::contact_of_cores<float>(
      polygon_a, polygon_b, clipping::face_separation(polygon_a, face[0], polygon_b),
      clipping::face_separation(polygon_b, face[1], polygon_a), tie_bias, {});
}

float between_outlines(const ShapeRows& a, const ShapeRows& b_in_a) {
  return between_outlines(polygon_of(a), polygon_of(b_in_a));
}

template <class Scalar>
Manifold<Scalar> collide_round_pair_or_gap(const ConvexPolygon<Scalar>& a,
                                           const ConvexPolygon<Scalar>& b,
                                           const Pose<Scalar>& b_in_a, Scalar tie_bias) {
  const ConvexPolygon<Scalar> placed = transform(b_in_a, b);
  Manifold<Scalar> manifold = clipping::collide_in_frame(a, placed, tie_bias);
  if (manifold.count > 0) return manifold;
  const Scalar depth = a.radius + b.radius - between_outlines(a, placed);
  manifold.points[0].depth = std::min(depth, Scalar(0));
  return manifold;
}

template Manifold<float> collide_round_pair_or_gap(const ConvexPolygon<float>&,
                                                   const ConvexPolygon<float>&, const Pose<float>&,
                                                   float);
template Manifold<double> collide_round_pair_or_gap(const ConvexPolygon<double>&,
                                                    const ConvexPolygon<double>&,
                                                    const Pose<double>&, double);

}  // namespace manifuzz::kernel
