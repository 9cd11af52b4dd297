#include "kernel/deepest_contact.hpp"

#include "clipping/collide.hpp"

// The clean code is flattened into each function here: as functions of its own, which the linker
// keeps once a program, it might come from a user's object file, compiled for another processor.

namespace manifuzz::kernel {

template <class Scalar>
[[gnu::flatten]] Manifold<Scalar> deepest_contact(const ColumnPair<Scalar>& pair) {
  ConvexPolygon<Scalar> polygons[2];
  for (int p = 0; p < 2; ++p) {
    polygons[p].count = pair.count[p];
    const Row<Scalar>* row = pair.corners[p];
    for (int i = 0; i < pair.count[p]; ++i, row += kCornerRows) {
      const auto at = [&](int element) { return row[element].column[pair.column]; };
      polygons[p].vertices[i] = {at(0), at(1)};
      polygons[p].normals[i] = {at(2), at(3)};
    }
  }
  polygons[0].radius = pair.total_radius;  // only the sum of the radii is ever looked at
  return clipping::deepest_contact(polygons[0], polygons[1]);
}

[[gnu::flatten]] Manifold<float> with_deepest_contact(const ShapeRows& a, const ShapeRows& b,
                                                      const Manifold<float>& manifold,
                                                      float separation, float greatest) {
  const ConvexPolygon<float> polygon_a = polygon_of(a);
  const ConvexPolygon<float> polygon_b = polygon_of(b);
  return clipping::misses_deepest(polygon_a, polygon_b, manifold, separation, greatest)
             ? clipping::deepest_contact(polygon_a, polygon_b)
             : manifold;
}

[[gnu::flatten]] Manifold<float> collide_cleanly(const ShapeRows& a, const ShapeRows& b,
                                                 float tie_bias) {
  return clipping::collide_in_frame(polygon_of(a), polygon_of(b), tie_bias);
}

template Manifold<float> deepest_contact(const ColumnPair<float>&);
template Manifold<double> deepest_contact(const ColumnPair<double>&);

}  // namespace manifuzz::kernel
