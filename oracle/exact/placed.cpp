#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oracle/exact/placed.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <cassert>
#include <hwy/highway.h>
#include <limits>

#include "geometry/lanes-inl.hpp"
#include "oracle/exact/placed.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::exact::HWY_NAMESPACE {

using namespace manifuzz::HWY_NAMESPACE;

/// A polygon as it stands, at `position` from A's.
HWY_INLINE void place(const StoredBody& body, double x, double y, RoughPolygon& placed) {
  const int count = body.polygon.count;
  const double cos = static_cast<double>(body.pose.rotation.x());
  const double sin = static_cast<double>(body.pose.rotation.y());
  const LanePoints corners = load_points(body.polygon.vertices[0].data());
  const LanePoints edges = next(corners, count) - corners;
  const LanePoints outward = turned(cos, sin, clockwise_quarter(edges));
  placed.count = count;
  store_points(turned(cos, sin, corners) + in_every_lane(x, y), placed.vertices[0].data());
  store_points(outward / root(dot(outward, outward)), placed.normals[0].data());
  if (count == 1) placed.normals[0] = {0, 0};
}

void place_both(const StoredPair& pair, RoughPair& placed) {
  const Pose<float>& a = pair.a.pose;
  const Pose<float>& b = pair.b.pose;
  place(pair.a, 0, 0, placed.a);
  place(pair.b, static_cast<double>(b.position.x()) - static_cast<double>(a.position.x()),
        static_cast<double>(b.position.y()) - static_cast<double>(a.position.y()), placed.b);
}

/// Of each face of a polygon, and the greatest; all faces at once meet each vertex of the other.
HWY_INLINE double separate(const RoughPolygon& polygon, const RoughPolygon& opposing,
                           LaneArray& of_face) {
  const LanePoints corners = load_points(polygon.vertices[0].data());
  const LanePoints normals = load_points(polygon.normals[0].data());
  const Lanes infinity = in_every_lane(std::numeric_limits<double>::infinity());
  Lanes least = infinity;
  for (int j = 0; j < opposing.count; ++j) {
    const double* const vertex = opposing.vertices[j].data();
    least = lesser(dot(normals, in_every_lane(vertex[0], vertex[1]) - corners), least);
  }
  store(least, of_face.data());
  return -least_of(select(first_lanes(polygon.face_count()), -least, infinity));
}

void place_and_separate(const StoredPair& pair, RoughPair& placed, Separations& found) {
  place_both(pair, placed);
  found.greatest = {separate(placed.a, placed.b, found.of_face[0]),
                    separate(placed.b, placed.a, found.of_face[1])};
}

}  // namespace manifuzz::exact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::exact {
namespace {

HWY_EXPORT(place_both);
HWY_EXPORT(place_and_separate);

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

Separations separations(const StoredPair& pair, double extent, RoughPair& placed) {
  Separations result;
  HWY_DYNAMIC_DISPATCH(place_and_separate)(pair, placed, result);
  result.error = kErrorOfSeparation * extent;
  return result;
}

}  // namespace manifuzz::exact
#endif
