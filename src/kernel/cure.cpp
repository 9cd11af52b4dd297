#include "kernel/cure.hpp"

#include "clipping/deepest_contact.hpp"

namespace manifuzz::kernel {

template <class Scalar>
Manifold<Scalar> deepest_contact(const LanePair<Scalar>& pair) {
  ConvexPolygon<Scalar> polygons[2];
  const Scalar* corner = pair.corners;
  for (int p = 0; p < 2; ++p) {
    polygons[p].count = pair.count[p];
    for (int i = 0; i < kMaxVertices; ++i, corner += 4 * pair.stride) {
      if (i >= pair.count[p]) continue;
      polygons[p].vertices[i] = {corner[0], corner[pair.stride]};
      polygons[p].normals[i] = {corner[2 * pair.stride], corner[3 * pair.stride]};
    }
  }
  polygons[0].radius = pair.total_radius;  // only the sum of the radii is ever looked at
  return clipping::deepest_contact(polygons[0], polygons[1]);
}

template Manifold<float> deepest_contact(const LanePair<float>&);
template Manifold<double> deepest_contact(const LanePair<double>&);

}  // namespace manifuzz::kernel
