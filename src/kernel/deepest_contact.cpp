#include "kernel/deepest_contact.hpp"

#include "clipping/collide.hpp"

// The clean code is flattened into each function here: as functions of its own, which the linker
// keeps once a program, it might come from a user's object file, compiled for another processor.

namespace manifuzz::kernel {

namespace {

template <class Scalar>
void copy_column(const ColumnPair<Scalar>& pair, ConvexPolygon<Scalar> (&polygons)[2]) {
  for (int p = 0; p < 2; ++p) {
    polygons[p].count = pair.count[p];
    polygons[p].radius = pair.radius[p];
    const Row<Scalar>* row = pair.corners[p];
    for (int i = 0; i < pair.count[p]; ++i, row += kCornerRows) {
      const auto at = [&](int element) { return row[element].column[pair.column]; };
      polygons[p].vertices[i] = {at(0), at(1)};
      polygons[p].normals[i] = {at(2), at(3)};
    }
  }
}

}  // namespace

template <class Scalar>
[[gnu::flatten]] Manifold<Scalar> deepest_contact_or(const ColumnPair<Scalar>& pair,
                                                     const Manifold<Scalar>& clipped) {
  ConvexPolygon<Scalar> polygons[2];
  copy_column(pair, polygons);
  return clipping::deepest_contact_or(polygons[0], polygons[1], clipped);
}

template <class Scalar>
[[gnu::flatten]] Manifold<Scalar> collide_round_column(const ColumnPair<Scalar>& pair,
                                                       Scalar tie_bias) {
  ConvexPolygon<Scalar> polygons[2];
  copy_column(pair, polygons);
  polygons[0].rounding = Rounding::round;  // one of them is, and which does not matter
  return clipping::collide_in_frame(polygons[0], polygons[1], tie_bias);
}

[[gnu::flatten]] Manifold<float> with_deepest_contact(const ShapeRows& a, const ShapeRows& b,
                                                      const Manifold<float>& manifold,
                                                      float separation, float greatest) {
  const ConvexPolygon<float> polygon_a = polygon_of(a);
  const ConvexPolygon<float> polygon_b = polygon_of(b);
  return clipping::misses_deepest(polygon_a, polygon_b, manifold, separation, greatest)
             ? clipping::deepest_contact_or(polygon_a, polygon_b, manifold)
             : manifold;
}

[[gnu::flatten]] Manifold<float> collide_cleanly(const ShapeRows& a, const ShapeRows& b,
                                                 float tie_bias) {
  return clipping::collide_in_frame(polygon_of(a), polygon_of(b), tie_bias);
}

template Manifold<float> deepest_contact_or(const ColumnPair<float>&, const Manifold<float>&);
template Manifold<double> deepest_contact_or(const ColumnPair<double>&, const Manifold<double>&);
template Manifold<float> collide_round_column(const ColumnPair<float>&, float);
template Manifold<double> collide_round_column(const ColumnPair<double>&, double);

}  // namespace manifuzz::kernel
