#pragma once

#include "clipping/clip.hpp"
#include "clipping/separation.hpp"

namespace manifuzz::clipping {

/// The farthest vertex's distance from the frame's origin, a length, as |x| + |y|: no square may
/// overflow.
template <class Scalar>
Scalar reach_in_frame(const ConvexPolygon<Scalar>& polygon) {
  Scalar reach = 0;
  for (const auto& v : polygon.corners())
    reach = std::max(reach, std::abs(v.x()) + std::abs(v.y()));
  return reach;
}

/// How much of a computed separation may be rounding, a length; both polygons in one frame. At most
/// 5.7 u E, E being the extent, is well inside the bound 15 u E on a separation's error: an overlap
/// deeper than the bound is computed deeper than this.
template <class Scalar>
Scalar separation_roundoff(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  constexpr Scalar u = std::numeric_limits<Scalar>::epsilon() / 2;
  return 4 * u * (reach_in_frame(a) + reach_in_frame(b));
}

/// Whether polygons overlap (`greatest` being the greatest separation) and the manifold is less
/// deep than its own face's `separation`, both by more than rounding: the face's slab misses the
/// deepest vertex.
template <class Scalar>
bool misses_deepest(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                    const Manifold<Scalar>& manifold, Scalar separation, Scalar greatest) {
  Scalar deepest = a.radius + b.radius;  // the face itself, where there is no point
  if (manifold.count > 0) deepest = manifold.points[0].depth;
  if (manifold.count > 1) deepest = std::max(deepest, manifold.points[1].depth);
  const Scalar missing = a.radius + b.radius - separation - deepest;
  const Scalar least = std::min(missing, -greatest);
  return least > 0 && least > separation_roundoff(a, b);
}

/// Whether the slab of a face, widened by `margin` (a length), holds a point of the polygon's
/// frame.
template <class Scalar>
bool slab_holds(const ConvexPolygon<Scalar>& polygon, int face_index, const Vector2<Scalar>& point,
                Scalar margin) {
  const Vector2<Scalar> along = counter_clockwise_quarter(polygon.normals[face_index]);
  return along.dot(point - polygon.vertices[face_index]) >= -margin &&
         along.dot(polygon.vertices[polygon.next(face_index)] - point) >= -margin;
}

/// The vertex of `opposing` that is deepest behind a face of polygon `side`, as the only contact
/// point. Both polygons, and the manifold, are in one frame.
template <class Scalar>
Manifold<Scalar> lone_vertex(const ConvexPolygon<Scalar>& reference, Side side,
                             const FaceSeparation<Scalar>& found,
                             const ConvexPolygon<Scalar>& opposing) {
  const ClipEnd<Scalar> end{opposing.vertices[found.deepest], face(found.face),
                            vertex(found.deepest)};
  Manifold<Scalar> manifold = keep_behind_face<Scalar>({end, end}, reference, found.face, side,
                                                       reference.radius + opposing.radius);
  manifold.count = 1;
  return manifold;
}

/// Whether a point is no farther in front of a face than the deepest vertex, and in the face's
/// slab, widened by `margin`, both but for `roundoff`; all are lengths.
template <class Scalar>
bool is_deepest_in_slab(const ConvexPolygon<Scalar>& polygon, const FaceSeparation<Scalar>& found,
                        const Vector2<Scalar>& point, Scalar margin, Scalar roundoff) {
  const Vector2<Scalar> from_face = point - polygon.vertices[found.face];
  return polygon.normals[found.face].dot(from_face) <= found.separation + roundoff &&
         slab_holds(polygon, found.face, point, margin + roundoff);
}

/// The manifold of a face whose slab holds the deepest of the overlap; empty where it does not. The
/// incident edge is the most opposed one, or one that rounding cannot tell from it, whose clip is
/// as deep as the face's separation; failing that, an end of such an edge alone that is as deep and
/// lies in the slab, or the deepest clip where the end is outside the slab by rounding only. An
/// end, since of a shape that is thinner than rounding any vertex may be called the deepest.
template <class Scalar>
Manifold<Scalar> contact_behind_face(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                     Side side, const FaceSeparation<Scalar>& found,
                                     Scalar roundoff) {
  const ConvexPolygon<Scalar>& reference = side == Side::a ? a : b;
  const ConvexPolygon<Scalar>& opposing = side == Side::a ? b : a;
  const Vector2<Scalar>& normal = reference.normals[found.face];
  const Scalar total_radius = a.radius + b.radius;
  const Scalar depth = total_radius - found.separation - roundoff;
  constexpr Scalar dot_roundoff =
      2 * std::numeric_limits<Scalar>::epsilon();  // less than half of 9 u
  const Scalar least = normal.dot(opposing.normals[incident_edge(opposing, normal)]);
  Manifold<Scalar> deepest_clip;
  Scalar depth_of_clip = 0;
  FaceSeparation<Scalar> lone = found;
  bool has_lone = false;
  for (int j = 0; j < opposing.count; ++j) {
    if (normal.dot(opposing.normals[j]) > least + dot_roundoff) continue;
    Manifold<Scalar> clipped = clip_features<Scalar>(a, b, {side, found.face, j});
    for (int k = 0; k < clipped.count; ++k) {
      if (clipped.points[k].depth >= depth) return clipped;
      if (clipped.points[k].depth < depth_of_clip) continue;
      depth_of_clip = clipped.points[k].depth;
      deepest_clip = clipped;
    }
    for (const int end : {j, opposing.next(j)}) {
      if (has_lone && end != found.deepest) continue;
      if (!is_deepest_in_slab(reference, found, opposing.vertices[end], slab_margin(a, b),
                              roundoff)) {
        continue;
      }
      lone.deepest = end;
      has_lone = true;
    }
  }
  if (!has_lone) return {};
  const bool clipped_off =
      deepest_clip.count > 0 &&
      !slab_holds(reference, found.face, opposing.vertices[lone.deepest], slab_margin(a, b));
  return clipped_off ? deepest_clip : lone_vertex(reference, side, lone, opposing);
}

/// The manifold of overlapping polygons whose features were chosen so that the clip kept nothing:
/// by a tie bias, or because two faces or edges are nearer than rounding can tell, and the slab of
/// the wrong one misses the deepest vertex. Takes the face of greatest separation, of either
/// polygon, whose slab holds it: the true one does, since the shortest way out of an overlap ends
/// inside a face. Neither the article nor Box2D does it: both report no contact there. Never empty:
/// the last resort is the deepest vertex alone.
template <class Scalar>
Manifold<Scalar> deepest_contact(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  const Scalar roundoff = separation_roundoff(a, b);
  Manifold<Scalar> contact;
  Manifold<Scalar> last_resort;
  Scalar greatest = -std::numeric_limits<Scalar>::infinity();
  Scalar greatest_of_all = greatest;
  for (const Side side : {Side::a, Side::b}) {
    const ConvexPolygon<Scalar>& reference = side == Side::a ? a : b;
    const ConvexPolygon<Scalar>& opposing = side == Side::a ? b : a;
    for (int i = 0; i < reference.face_count(); ++i) {
      const FaceSeparation<Scalar> found = face_separation(reference, i, opposing);
      if (found.separation > greatest_of_all) {
        greatest_of_all = found.separation;
        last_resort = lone_vertex(reference, side, found, opposing);
      }
      if (found.separation <= greatest) continue;
      const Manifold<Scalar> behind = contact_behind_face(a, b, side, found, roundoff);
      if (behind.count == 0) continue;
      greatest = found.separation;
      contact = behind;
    }
  }
  return contact.count > 0 ? contact : last_resort;
}

}  // namespace manifuzz::clipping
