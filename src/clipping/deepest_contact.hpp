#pragma once

#include "clipping/clip.hpp"
#include "clipping/separation.hpp"

namespace manifuzz::clipping {

/// What rounding can do to a separation: 8 u (reach of A + reach of B + distance of their origins).
template <class Scalar>
Scalar separation_roundoff(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  Scalar squared_a = 0;
  Scalar squared_b = 0;
  for (const auto& v : a.corners()) squared_a = std::max(squared_a, v.dot(v));
  for (const auto& v : b.corners()) squared_b = std::max(squared_b, v.dot(v));
  // Seen from A, |v_b| already holds the distance of the origins, which may cost a factor of two.
  constexpr Scalar u = std::numeric_limits<Scalar>::epsilon() / 2;
  return 8 * u * (std::sqrt(squared_a) + 2 * std::sqrt(squared_b));
}

/// Whether the slab of a face, widened by `margin`, holds a point.
template <class Scalar>
bool slab_holds(const ConvexPolygon<Scalar>& polygon, int face_index, const Vector2<Scalar>& point,
                Scalar margin) {
  const Vector2<Scalar> along = counter_clockwise_quarter(polygon.normals[face_index]);
  return along.dot(point - polygon.vertices[face_index]) >= -margin &&
         along.dot(polygon.vertices[polygon.next(face_index)] - point) >= -margin;
}

/// A face, and the vertex of the other polygon that is deepest behind it.
template <class Scalar>
struct DeepestVertex {
  Side side = Side::a;
  FaceSeparation<Scalar> face;
};

/// The face of greatest separation, of either polygon, among those whose slab holds their deepest
/// vertex, within rounding: the true one does, since the shortest way out of an overlap ends inside
/// a face. Among all, should rounding leave none.
template <class Scalar>
DeepestVertex<Scalar> deepest_vertex_held(const ConvexPolygon<Scalar>& a,
                                          const ConvexPolygon<Scalar>& b) {
  DeepestVertex<Scalar> held;
  DeepestVertex<Scalar> any;
  const Scalar margin = a.radius + b.radius + separation_roundoff(a, b);
  for (const Side side : {Side::a, Side::b}) {
    const ConvexPolygon<Scalar>& polygon = side == Side::a ? a : b;
    const ConvexPolygon<Scalar>& opposing = side == Side::a ? b : a;
    for (int i = 0; i < polygon.count; ++i) {
      const FaceSeparation<Scalar> face = face_separation(polygon, i, opposing);
      if (face.separation > any.face.separation) any = {side, face};
      if (face.separation > held.face.separation &&
          slab_holds<Scalar>(polygon, i, opposing.vertices[face.deepest], margin)) {
        held = {side, face};
      }
    }
  }
  return std::isfinite(held.face.separation) ? held : any;
}

/// The manifold of overlapping polygons whose features were chosen so that the clip kept nothing:
/// by a tie bias, or because two faces or edges are nearer than rounding can tell, and the slab of
/// the wrong one misses the deepest vertex. Never empty: the last resort is that vertex alone.
template <class Scalar>
Manifold<Scalar> deepest_contact(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  const DeepestVertex<Scalar> deepest = deepest_vertex_held(a, b);
  const bool from_a = deepest.side == Side::a;
  const ConvexPolygon<Scalar>& reference = from_a ? a : b;
  const ConvexPolygon<Scalar>& opposing = from_a ? b : a;
  const int corner = deepest.face.deepest;
  const int face_index = deepest.face.face;
  const Vector2<Scalar>& normal = reference.normals[face_index];
  const int previous = opposing.previous(corner);
  const bool take_previous =
      normal.dot(opposing.normals[previous]) <= normal.dot(opposing.normals[corner]);
  const Manifold<Scalar> clipped =
      clip_features<Scalar>(a, b, {deepest.side, face_index, take_previous ? previous : corner});
  if (clipped.count > 0) return clipped;
  const ClipEnd<Scalar> alone{opposing.vertices[corner], face(face_index), vertex(corner)};
  Manifold<Scalar> manifold = keep_behind_face<Scalar>({alone, alone}, reference, face_index,
                                                       deepest.side, a.radius + b.radius);
  manifold.count = 1;
  return manifold;
}

}  // namespace manifuzz::clipping
