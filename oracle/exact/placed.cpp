#include "oracle/exact/placed.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "geometry/lanes.hpp"

namespace manifuzz::exact {
namespace {

// With u = 2^-53 and E the extent, rotations being unit to 1e-5. As a vector, a placed vertex is
// off by 1.42 u of its reach from two products, u from their sum, u E from the sum with a position
// that is off by u of its length: the difference of two by less than 10 u E. The face's edge is a
// rounded difference, turned by two products and a sum, made unit by a root of a sum of squares and
// a division: off by less than 8 u in all. The dot of both adds 2 u E: together 20 u E, and half as
// much again for good measure. The dot of two normals is off by 8 u + 8 u + 2 u.
constexpr double kErrorOfSeparation = 0x1p-48;  // 32 u

RoughPolygon place(const StoredBody& body, const Vector2<double>& position) {
  const StoredPolygon& polygon = body.polygon;
  const Vector2<double> rotation = body.pose.rotation.cast<double>();
  RoughPolygon placed;
  placed.count = polygon.count;
  for (int i = 0; i < placed.count; ++i) {
    const Vector2<double>& corner = polygon.vertices[i];
    const Vector2<double> edge = polygon.vertices[polygon.next(i)] - corner;
    const Vector2<double> outward = rotate<double>(rotation, clockwise_quarter(edge));
    placed.vertices[i] = rotate<double>(rotation, corner) + position;
    placed.normals[i] = outward / std::sqrt(outward.dot(outward));
  }
  if (placed.count == 1) placed.normals[0] = {0, 0};
  return placed;
}

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
  return {place(pair.a, {0, 0}),
          place(pair.b, pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>())};
}

namespace {

/// Of each face of a polygon; all of them at once meet each vertex of the other.
LaneArray separations(const RoughPolygon& polygon, const RoughPolygon& opposing) {
  LaneArray corner_x{};
  LaneArray corner_y{};
  LaneArray normal_x{};
  LaneArray normal_y{};
  for (int i = 0; i < polygon.count; ++i) {
    corner_x[i] = polygon.vertices[i].x();
    corner_y[i] = polygon.vertices[i].y();
    normal_x[i] = polygon.normals[i].x();
    normal_y[i] = polygon.normals[i].y();
  }
  Lanes least(std::numeric_limits<double>::infinity());
  for (int j = 0; j < opposing.count; ++j) {
    const Lanes apart_x = Lanes(opposing.vertices[j].x()) - Lanes(corner_x);
    const Lanes apart_y = Lanes(opposing.vertices[j].y()) - Lanes(corner_y);
    least = min(least, Lanes(normal_x) * apart_x + Lanes(normal_y) * apart_y);
  }
  return least.array();
}

}  // namespace

Separations separations(const RoughPair& placed, double extent) {
  Separations result;
  result.error = kErrorOfSeparation * extent;
  for (const Side side : {Side::a, Side::b}) {
    const RoughPolygon& polygon = placed[side];
    auto& of_face = result.of_face[static_cast<std::size_t>(side)];
    of_face = separations(polygon, placed[other(side)]);
    result.greatest[static_cast<std::size_t>(side)] =
        polygon.face_count() > 0
            ? *std::max_element(of_face.begin(), of_face.begin() + polygon.count)
            : -std::numeric_limits<double>::infinity();
  }
  return result;
}

}  // namespace manifuzz::exact
