#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "exact/placed.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <algorithm>
#include <cassert>
#include <cmath>
#include <hwy/highway.h>
#include <limits>

#include "exact/placed.hpp"
#include "geometry/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::exact::HWY_NAMESPACE {

using namespace manifuzz::HWY_NAMESPACE;

/// A polygon as it stands: its corners, and its faces' unit normals.
template <int n>
struct Placed {
  LanePoints<n> corners;
  LanePoints<n> normals;
};

/// At a place from A's position.
template <int n, class AnyBody>
HWY_INLINE Placed<n> place(const AnyBody& body, double x, double y) {
  const double cos = static_cast<double>(body.pose.rotation.x());
  const double sin = static_cast<double>(body.pose.rotation.y());
  const LanePoints<n> corners = load_points<n>(body.polygon.vertices[0].data(), body.polygon.count);
  const LanePoints<n> edges = next(corners, body.polygon.count) - corners;
  const LanePoints<n> outward = turned(cos, sin, clockwise_quarter(edges));
  return {turned(cos, sin, corners) + in_every_lane<n>(x, y),
          outward / root(dot(outward, outward))};
}
template <int n, class AnyPair>
HWY_INLINE Placed<n> place_a(const AnyPair& pair) {
  return place<n>(pair.a, 0, 0);
}
template <int n, class AnyPair>
HWY_INLINE Placed<n> place_b(const AnyPair& pair) {
  const Vector2<float>& a = pair.a.pose.position;
  const Vector2<float>& b = pair.b.pose.position;
  return place<n>(pair.b, static_cast<double>(b.x()) - static_cast<double>(a.x()),
                  static_cast<double>(b.y()) - static_cast<double>(a.y()));
}

HWY_INLINE void store_placed(const Placed<kParts>& from, int count, RoughPolygon& placed) {
  placed.count = count;
  store_points(from.corners, placed.vertices[0].data());
  store_points(from.normals, placed.normals[0].data());
  if (count == 1) placed.normals[0] = {0, 0};
}

void place_both(const StoredPair& pair, RoughPair& placed) {
  store_placed(place_a<kParts>(pair), pair.a.polygon.count, placed.a);
  store_placed(place_b<kParts>(pair), pair.b.polygon.count, placed.b);
}

/// The separation of each face of a polygon, and the greatest; all faces at once meet each vertex
/// of the other. A point has no face: what comes of its lane is anything.
template <int n, int m>
HWY_INLINE double separate(const Placed<n>& polygon, int face_count, const Placed<m>& opposing,
                           int count, LaneArray& of_face) {
  double x[m * kPart];
  double y[m * kPart];
  store(opposing.corners.x, x);
  store(opposing.corners.y, y);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Lanes<n> least = in_every_lane<n>(infinity);
  for (int j = 0; j < std::min(count, m * kPart); ++j) {
    least = lesser(dot(polygon.normals, in_every_lane<n>(x[j], y[j]) - polygon.corners), least);
  }
  store(least, of_face.data());
  return -least_of(select(first_lanes<n>(face_count), -least, in_every_lane<n>(infinity)));
}

template <int n, int m, class AnyPair>
HWY_INLINE void separate_any(const AnyPair& pair, Separations& found) {
  const auto& a = pair.a.polygon;
  const auto& b = pair.b.polygon;
  const Placed<n> placed_a = place_a<n>(pair);
  const Placed<m> placed_b = place_b<m>(pair);
  found.greatest = {separate(placed_a, a.face_count(), placed_b, b.count, found.of_face[0]),
                    separate(placed_b, b.face_count(), placed_a, a.count, found.of_face[1])};
}

void separate_stored(const StoredPair& pair, Separations& found) {
  separate_any<kParts, kParts>(pair, found);
}

/// The square of a polygon's reach.
template <int n>
HWY_INLINE double squared_reach(const ConvexPolygon<float>& polygon) {
  const LanePoints<n> corners = load_points<n>(polygon.vertices[0].data(), polygon.count);
  return -least_of(
      select(first_lanes<n>(polygon.count), -dot(corners, corners), in_every_lane<n>(0)));
}

/// With the extent, as `extent` has it.
template <int n, int m>
HWY_INLINE void separate_parts(const PairCase& pair, Separations& found) {
  const Vector2<double> apart =
      pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>();
  found.extent = std::sqrt(squared_reach<n>(pair.a.polygon)) +
                 std::sqrt(squared_reach<m>(pair.b.polygon)) + std::sqrt(apart.dot(apart));
  separate_any<n, m>(pair, found);
}

template <int n>
HWY_INLINE void separate_from(const PairCase& pair, Separations& found) {
  if (fits_half(pair.b.polygon.count)) return separate_parts<n, kHalf>(pair, found);
  separate_parts<n, kParts>(pair, found);
}

void separate_floats(const PairCase& pair, Separations& found) {
  if (fits_half(pair.a.polygon.count)) return separate_from<kHalf>(pair, found);
  separate_from<kParts>(pair, found);
}

}  // namespace manifuzz::exact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::exact {
namespace {

HWY_EXPORT(place_both);
HWY_EXPORT(separate_stored);
HWY_EXPORT(separate_floats);

// With u = 2^-53 and E the extent, rotations being unit to 1e-5. As a vector, a placed vertex is
// off by 1.42 u of its reach from two products, u from their sum, u E from the sum with a position
// that is off by u of its length: the difference of two by less than 10 u E. The face's edge is a
// rounded difference, turned by two products and a sum, made unit by a root of a sum of squares and
// a division: off by less than 8 u in all. The dot of both adds 2 u E: together 20 u E, and half as
// much again for good measure. The dot of two normals is off by 8 u + 8 u + 2 u.
constexpr double kErrorOfSeparation = 0x1p-48;  // 32 u

StoredBody stored(const Body& body) {
  StoredBody result{.polygon = {.vertices = {},
                                .count = body.polygon.count,
                                .radius = static_cast<double>(body.polygon.radius)},
                    .pose = body.pose};
  for (int i = 0; i < body.polygon.count; ++i) {
    result.polygon.vertices[i] = body.polygon.vertices[i].cast<double>();
  }
  return result;
}

StoredBody stored(const Body& body, const UsedVertices& used) {
  assert(used.count >= 1 && used.count <= kMaxVertices);
  StoredBody result = stored(body);
  result.polygon.count = used.count;
  result.polygon.vertices = used.all;
  if (used.round_radius) result.polygon.radius = static_cast<double>(*used.round_radius);
  return result;
}

}  // namespace

StoredPair stored(const PairCase& pair) {
  return {stored(pair.a), stored(pair.b)};
}

StoredPair stored(const PairCase& pair, const UsedShapes& used) {
  return {stored(pair.a, used.a), stored(pair.b, used.b)};
}

RoughPair place_roughly(const StoredPair& pair) {
  RoughPair placed;
  HWY_DYNAMIC_DISPATCH(place_both)(pair, placed);
  return placed;
}

Separations separations(const PairCase& pair) {
  Separations result;
  HWY_DYNAMIC_DISPATCH(separate_floats)(pair, result);
  result.error = kErrorOfSeparation * result.extent;
  return result;
}

Separations separations(const StoredPair& pair, double extent) {
  Separations result;
  HWY_DYNAMIC_DISPATCH(separate_stored)(pair, result);
  result.extent = extent;
  result.error = kErrorOfSeparation * extent;
  return result;
}

}  // namespace manifuzz::exact
#endif
