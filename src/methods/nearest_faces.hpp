#pragma once

#include <algorithm>
#include <optional>

#include "clipping/nearest.hpp"
#include "methods/gjk.hpp"

// From what GJK and EPA find, which are vertices, to faces with their own normals: the separation
// along these is as accurate as that of clipping, and no search over all faces is needed.

namespace manifuzz::methods {

/// A face of either core, and how far the other lies in front of it.
template <class Scalar>
struct FoundFace {
  Side side = Side::a;                       ///< whose face it is
  clipping::FaceSeparation<Scalar> found{};  ///< its index and separation
};

/// The faces at or between a feature's vertices, and their greatest separations.
template <class Scalar>
struct NearestFaces {
  /// Each face of a core once, and the first twice where it is the last as well.
  static constexpr int kMax = 2 * (kMaxVertices + 1);

  std::array<FoundFace<Scalar>, kMax> all;  ///< `count` of them
  int count = 0;                            ///< of all
  clipping::FaceSeparation<Scalar> of_a;    ///< A's greatest; minus infinity where A is a point
  clipping::FaceSeparation<Scalar> of_b;    ///< the same of B

  /// Whether A's separates at least as much.
  bool is_of_a() const { return of_a.separation >= of_b.separation; }
  /// The greater separation.
  Scalar separation() const { return std::max(of_a.separation, of_b.separation); }
  /// The face that has it.
  FoundFace<Scalar> greatest() const {
    return is_of_a() ? FoundFace<Scalar>{Side::a, of_a} : FoundFace<Scalar>{Side::b, of_b};
  }
};

/// Adds a side's faces from the one before vertex `first` to the one after vertex `last`,
/// counter-clockwise.
template <class Scalar>
void add_faces(const ConvexPolygon<Scalar>& core, Side side, int first, int last,
               const ConvexPolygon<Scalar>& other, NearestFaces<Scalar>& faces) {
  if (core.face_count() == 0) return;
  clipping::FaceSeparation<Scalar>& greatest = side == Side::a ? faces.of_a : faces.of_b;
  const auto add = [&](int face) {
    const auto found = clipping::face_separation(core, face, other);
    faces.all[faces.count++] = {side, found};
    if (found.separation > greatest.separation) greatest = found;
  };
  add(core.previous(first));
  for (int i = first; i != last; i = core.next(i)) add(i);
  add(last);
}

/// Whether some face from the one before vertex `first` to the one after vertex `last` faces along
/// a direction; of a shape that is thinner than rounding the vertices may be those of the far side.
template <class Scalar>
bool has_face_along(const ConvexPolygon<Scalar>& core, int first, int last,
                    const Vector2<Scalar>& direction) {
  for (int i = first; i != last; i = core.next(i)) {
    if (clipping::has_edge_along(core, i, direction)) return true;
  }
  return clipping::has_edge_along(core, last, direction);
}

/// The faces at the feature of 1 or 2 vertices of the difference that is nearest to the origin,
/// from which `to_feature` leads there, of any length. A face's separation is never more than the
/// true one, so that looking at too many faces does no harm; and the nearest face is among these,
/// since the difference's outline between its vertices consists of faces of A and B between theirs.
/// Where none of a core's faces the other, all are.
template <class Scalar>
NearestFaces<Scalar> nearest_faces(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                   const Simplex& feature, const Vector2<double>& to_feature) {
  const SupportPair first = feature.vertices[0];
  const SupportPair last = feature.vertices[feature.count - 1];
  const Vector2<Scalar> inward = to_feature.template cast<Scalar>();
  NearestFaces<Scalar> faces;
  const auto add = [&](const ConvexPolygon<Scalar>& core, Side side, int from, int to,
                       const ConvexPolygon<Scalar>& other, const Vector2<Scalar>& outward) {
    const bool is_near_side = has_face_along(core, from, to, outward);
    add_faces(core, side, from, is_near_side ? to : core.previous(core.previous(from)), other,
              faces);
  };
  add(a, Side::a, first.a, last.a, b, inward);
  add(b, Side::b, first.b, last.b, a, -inward);
  return faces;
}

/// What of the other core counts as the place that is nearest to a face.
enum class PlaceAtFace : unsigned char {
  corner,   ///< a corner alone: where cores are apart and no corner is, corners are nearest
  on_edge,  ///< or where an edge leaves the slab between the face's ends
};

/// A place of the other core at a face, and what makes it.
template <class Scalar>
struct PlaceOfOther {
  Vector2<Scalar> position{0, 0};  ///< on the other core, in the common frame
  Feature of_face;                 ///< the face, or the end of it that cuts an edge of the other
  Feature of_other;                ///< a corner of the other, or that edge
};

/// Where the other core is nearest to a face between the face's ends: at its deepest vertex, or
/// farther along its outline to one side, if it is no farther away there than `most`, a length;
/// nothing where there is no such place.
template <class Scalar>
std::optional<PlaceOfOther<Scalar>> place_along(const ConvexPolygon<Scalar>& polygon,
                                                const clipping::FaceSeparation<Scalar>& found,
                                                const ConvexPolygon<Scalar>& other,
                                                PlaceAtFace what, Scalar most, bool goes_back) {
  const Vector2<Scalar>& from = polygon.vertices[found.face];
  const Vector2<Scalar>& to = polygon.vertices[polygon.next(found.face)];
  const Vector2<Scalar> along = clipping::along_face(polygon, found.face);
  const auto before = [&](int j) { return along.dot(from - other.vertices[j]); };
  const auto after = [&](int j) { return along.dot(other.vertices[j] - to); };
  const bool is_before = before(found.deepest) > 0;
  const auto outside = [&](int j) { return is_before ? before(j) : after(j); };
  int last = found.deepest;
  int j = last;
  for (int steps = 0; outside(j) > 0; ++steps) {
    last = j;
    j = goes_back ? other.previous(j) : other.next(j);
    // Rounding leaves edges without length, which lead nowhere and no farther away.
    if (outside(j) > outside(last) || steps == other.count) return std::nullopt;
  }
  PlaceOfOther<Scalar> place{other.vertices[j], clipping::face(found.face), clipping::vertex(j)};
  if (j != last && what == PlaceAtFace::on_edge) {
    const Scalar share = outside(last) / (outside(last) - outside(j));
    place = {other.vertices[last] + share * (other.vertices[j] - other.vertices[last]),
             clipping::vertex(is_before ? found.face : polygon.next(found.face)),
             clipping::face(goes_back ? j : last)};
  } else if ((is_before ? after(j) : before(j)) > 0) {
    return std::nullopt;
  }
  if (polygon.normals[found.face].dot(place.position - from) > most) return std::nullopt;
  return place;
}

/// As above, to the side that leads to the face. The other's edges run against it: what is farther
/// along it comes before. Those of a far side run along it, which matters where rounding took one
/// of their vertices for the deepest.
template <class Scalar>
std::optional<PlaceOfOther<Scalar>> place_inside_face(const ConvexPolygon<Scalar>& polygon,
                                                      const clipping::FaceSeparation<Scalar>& found,
                                                      const ConvexPolygon<Scalar>& other,
                                                      PlaceAtFace what, Scalar most) {
  const Vector2<Scalar> from_deepest = polygon.vertices[found.face] - other.vertices[found.deepest];
  const bool is_before = clipping::along_face(polygon, found.face).dot(from_deepest) > 0;
  const auto place = place_along(polygon, found, other, what, most, is_before);
  return place ? place : place_along(polygon, found, other, what, most, !is_before);
}

}  // namespace manifuzz::methods
