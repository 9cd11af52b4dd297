#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

/// The depth of the deepest point, of a manifold that has some.
template <class Scalar>
Scalar greatest_depth(const Manifold<Scalar>& manifold) {
  const Scalar first = manifold.points[0].depth;
  return manifold.count > 1 ? std::max(first, manifold.points[1].depth) : first;
}

/// Whether polygons overlap (`greatest` being the greatest separation) and the manifold is less
/// deep than its own face's `separation`, both by more than rounding: the face's slab misses the
/// deepest vertex. What a point misses is a difference of sums with the total radius, rounded as
/// such. Inlined: as a function of its own it costs polygons 2%.
template <class Scalar>
[[gnu::always_inline]] inline bool misses_deepest(const ConvexPolygon<Scalar>& a,
                                                  const ConvexPolygon<Scalar>& b,
                                                  const Manifold<Scalar>& manifold,
                                                  Scalar separation, Scalar greatest) {
  // Without a point it is the face itself.
  const Scalar deepest = manifold.count > 0 ? greatest_depth(manifold) : a.radius + b.radius;
  const Scalar missing = a.radius + b.radius - separation - deepest;
  if (std::min(missing, -greatest) <= 0) return false;
  constexpr Scalar u = std::numeric_limits<Scalar>::epsilon() / 2;
  const Scalar roundoff = separation_roundoff(a, b);
  const Scalar of_sums = manifold.count > 0 ? 4 * u * (a.radius + b.radius) : Scalar(0);
  return -greatest > roundoff && missing > roundoff + of_sums;
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

/// What is behind a face whose slab holds the deepest of the overlap.
template <class Scalar>
struct BehindFace {
  Manifold<Scalar> manifold;  ///< empty where the slab does not hold it
  bool is_deep_clip = false;  ///< whether it is a clip as deep; else what rounding left of one
};

/// Calls `visit(edge, dot)` for each edge that may be incident to a face of this normal: the most
/// opposed one, and those that rounding cannot tell from it; with the dot of both normals.
template <class Scalar, class Visit>
void for_each_opposed_edge(const ConvexPolygon<Scalar>& opposing, const Vector2<Scalar>& normal,
                           const Visit& visit) {
  constexpr Scalar dot_roundoff =
      2 * std::numeric_limits<Scalar>::epsilon();  // less than half of 9 u
  const Scalar least = normal.dot(opposing.normals[incident_edge(opposing, normal)]);
  for (int j = 0; j < opposing.count; ++j) {
    const Scalar dot = normal.dot(opposing.normals[j]);
    if (dot <= least + dot_roundoff) visit(j, dot);
  }
}

/// The clips of a face's incident edges that rounding cannot tell apart.
template <class Scalar>
struct ClipsBehindFace {
  Manifold<Scalar> most_opposed;  ///< of those as deep as asked for; empty where none is
  Manifold<Scalar> deepest;       ///< the last of equals; empty where none keeps anything
};

/// The clips behind a face, the most opposed one of those that are as deep as `depth`, a length.
template <class Scalar>
ClipsBehindFace<Scalar> clips_behind_face(const ConvexPolygon<Scalar>& a,
                                          const ConvexPolygon<Scalar>& b, Side side, int face_index,
                                          Scalar depth) {
  const ConvexPolygon<Scalar>& reference = side == Side::a ? a : b;
  const ConvexPolygon<Scalar>& opposing = side == Side::a ? b : a;
  ClipsBehindFace<Scalar> clips;
  Scalar least_dot = std::numeric_limits<Scalar>::infinity();
  for_each_opposed_edge(opposing, reference.normals[face_index], [&](int edge, Scalar dot) {
    const Manifold<Scalar> clipped = clip_features<Scalar>(a, b, {side, face_index, edge});
    if (clipped.count == 0) return;
    const Scalar depth_of_this = greatest_depth(clipped);
    if (depth_of_this >= depth && dot < least_dot) {
      clips.most_opposed = clipped;
      least_dot = dot;
    }
    const bool is_first = clips.deepest.count == 0;
    if (is_first || depth_of_this >= greatest_depth(clips.deepest)) clips.deepest = clipped;
  });
  return clips;
}

/// An end of an incident edge that is as deep as the deepest vertex and lies in the face's slab,
/// both but for `roundoff`; the deepest vertex itself where it is one. An end, since of a shape
/// that is thinner than rounding any vertex may be called the deepest.
template <class Scalar>
std::optional<int> deepest_end(const ConvexPolygon<Scalar>& reference,
                               const FaceSeparation<Scalar>& found,
                               const ConvexPolygon<Scalar>& opposing, Scalar margin,
                               Scalar roundoff) {
  std::optional<int> deepest;
  for_each_opposed_edge(opposing, reference.normals[found.face], [&](int edge, Scalar) {
    for (const int end : {edge, opposing.next(edge)}) {
      if (deepest && end != found.deepest) continue;
      const Vector2<Scalar>& corner = opposing.vertices[end];
      if (is_deepest_in_slab(reference, found, corner, margin, roundoff)) deepest = end;
    }
  });
  return deepest;
}

/// The clip behind a face whose slab holds the deepest of the overlap, of the most opposed edge of
/// those that rounding cannot tell apart and whose clip is as deep as the face's separation;
/// failing that, an end of such an edge alone that is as deep and lies in the slab, or the deepest
/// clip where the end is outside the slab by rounding only.
template <class Scalar>
BehindFace<Scalar> contact_behind_face(const ConvexPolygon<Scalar>& a,
                                       const ConvexPolygon<Scalar>& b, Side side,
                                       const FaceSeparation<Scalar>& found, Scalar roundoff) {
  const ConvexPolygon<Scalar>& reference = side == Side::a ? a : b;
  const ConvexPolygon<Scalar>& opposing = side == Side::a ? b : a;
  const Scalar margin = slab_margin(a, b);
  const Scalar depth = a.radius + b.radius - found.separation - roundoff;
  const ClipsBehindFace<Scalar> clips = clips_behind_face(a, b, side, found.face, depth);
  if (clips.most_opposed.count > 0) return {clips.most_opposed, true};
  const auto end = deepest_end(reference, found, opposing, margin, roundoff);
  if (!end) return {};
  const bool is_clipped_off = clips.deepest.count > 0 &&
                              !slab_holds(reference, found.face, opposing.vertices[*end], margin);
  if (is_clipped_off) return {clips.deepest, false};
  const FaceSeparation<Scalar> at_end{found.face, found.separation, *end};
  return {lone_vertex(reference, side, at_end, opposing), false};
}

/// The contact of an overlap that is as deep as the overlap, by the face of greatest separation
/// whose slab holds the deepest vertex; or that vertex alone.
template <class Scalar>
struct DeepestContact {
  Manifold<Scalar> manifold;     ///< empty where no slab holds a deepest vertex
  Scalar excess = 0;             ///< by how much faces that hold it separate less than the greatest
  Manifold<Scalar> lone_vertex;  ///< behind the face of greatest separation, whatever its slab
  Scalar overlap = 0;            ///< how deep the greatest separation says that they overlap
};

/// For overlapping polygons whose features were chosen so that the clip kept too little: by a tie
/// bias, or because two faces or edges are nearer than rounding can tell, and the slab of the wrong
/// one misses the deepest vertex. The true face's slab holds it, since the shortest way out of an
/// overlap ends inside a face. A face that a clip is behind goes before one that separates more by
/// no more than rounding and has only part of one: what that lacks is as much as a sliver is long.
/// Neither the article nor Box2D does it: both report no contact there.
template <class Scalar>
DeepestContact<Scalar> find_deepest_contact(const ConvexPolygon<Scalar>& a,
                                            const ConvexPolygon<Scalar>& b) {
  constexpr Scalar none = -std::numeric_limits<Scalar>::infinity();
  const Scalar roundoff = separation_roundoff(a, b);
  DeepestContact<Scalar> deepest;
  Scalar certain_of_chosen = none;  // its separation, less what rounding may add to it
  Scalar greatest_that_holds = none;
  Scalar greatest_of_all = none;
  for_each_face(a, b, [&](Side side, const auto& reference, int face_index, const auto& opposing) {
    const FaceSeparation<Scalar> found = face_separation(reference, face_index, opposing);
    if (found.separation > greatest_of_all) {
      greatest_of_all = found.separation;
      deepest.lone_vertex = lone_vertex(reference, side, found, opposing);
    }
    if (found.separation <= certain_of_chosen) return;
    const BehindFace<Scalar> behind = contact_behind_face(a, b, side, found, roundoff);
    if (behind.manifold.count == 0) return;
    greatest_that_holds = std::max(greatest_that_holds, found.separation);
    const Scalar certain = behind.is_deep_clip ? found.separation : found.separation - roundoff;
    if (certain <= certain_of_chosen) return;
    certain_of_chosen = certain;
    deepest.manifold = behind.manifold;
  });
  deepest.excess = greatest_of_all - greatest_that_holds;
  deepest.overlap = -greatest_of_all;
  return deepest;
}

/// Whether the face of a deepest contact is no answer to the overlap, though no other one holds its
/// deepest vertex. Let e be the error of a computed separation, and b its bound, which is e rounded
/// up by 0.3 u E (src/judging/bounds.md). Polygons that overlap by more than b are computed to
/// overlap by b - e = 0.3 u E at least, and the true face, which holds the vertex, to separate less
/// than the greatest by 2 e at most: 171 times as much in double, 98 in float.
template <class Scalar>
bool is_far_off(const DeepestContact<Scalar>& deepest) {
  return deepest.manifold.count > 0 && deepest.excess > 256 * deepest.overlap;
}

/// The deepest contact of an overlap; never empty.
template <class Scalar>
Manifold<Scalar> deepest_contact(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  const DeepestContact<Scalar> deepest = find_deepest_contact(a, b);
  return deepest.manifold.count == 0 || is_far_off(deepest) ? deepest.lone_vertex
                                                            : deepest.manifold;
}

/// The deepest contact in place of a clip that misses the deepest, unless that is worse: its face
/// separates less, by more than the clip lacks of the depth. Where nothing was kept and its face is
/// far off, they overlap by no more than rounding, and nothing is right; where no face holds the
/// deepest vertex, that is taken alone.
template <class Scalar>
Manifold<Scalar> deepest_contact_or(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const Manifold<Scalar>& clipped) {
  const DeepestContact<Scalar> deepest = find_deepest_contact(a, b);
  if (deepest.manifold.count == 0) return clipped.count > 0 ? clipped : deepest.lone_vertex;
  if (clipped.count == 0) return is_far_off(deepest) ? clipped : deepest.manifold;
  const Scalar lacking = a.radius + b.radius + deepest.overlap - greatest_depth(clipped);
  return deepest.excess > lacking ? clipped : deepest.manifold;
}

}  // namespace manifuzz::clipping
