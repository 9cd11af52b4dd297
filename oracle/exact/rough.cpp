#include "oracle/exact/rough.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manifuzz::exact {
namespace {

// With u = 2^-53 and E the extent, rotations being unit to 1e-5. A product of two floats is exact
// in double, so the coordinates of a placed vertex are off by less than 3 u E each, the difference
// of two vertices by less than 6 u E as a vector. The face's edge is a rounded difference, turned
// by two products and a sum, made unit by a root of a sum of squares and a division: off by less
// than 8 u in all. The dot of both adds 2 u E: together 16 u E, doubled for good measure. The dot
// of two normals is off by 8 u + 8 u + 2 u.
constexpr double kErrorOfSeparation = 0x1p-48;  // 32 u

RoughPolygon place(const Body& body, const Vector2<double>& position) {
  const ConvexPolygon<float>& polygon = body.polygon;
  const Vector2<double> rotation = body.pose.rotation.cast<double>();
  RoughPolygon placed;
  placed.count = polygon.count;
  for (int i = 0; i < placed.count; ++i) {
    const Vector2<double> corner = polygon.vertices[i].cast<double>();
    const Vector2<double> edge = polygon.vertices[polygon.next(i)].cast<double>() - corner;
    const Vector2<double> outward = rotate<double>(rotation, clockwise_quarter(edge));
    placed.vertices[i] = rotate<double>(rotation, corner) + position;
    placed.normals[i] = outward / std::sqrt(outward.dot(outward));
  }
  return placed;
}

}  // namespace

RoughPair place_roughly(const PairCase& pair) {
  return {place(pair.a, {0, 0}),
          place(pair.b, pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>())};
}

Separations separations(const RoughPair& placed, double extent) {
  Separations result;
  result.error = kErrorOfSeparation * extent;
  for (const Side side : {Side::a, Side::b}) {
    const RoughPolygon& polygon = placed[side];
    const RoughPolygon& opposing = placed[other(side)];
    auto& of_face = result.of_face[static_cast<std::size_t>(side)];
    for (int i = 0; i < polygon.count; ++i) {
      of_face[i] = std::numeric_limits<double>::infinity();
      for (int j = 0; j < opposing.count; ++j) {
        const Vector2<double> apart = opposing.vertices[j] - polygon.vertices[i];
        of_face[i] = std::min(of_face[i], polygon.normals[i].dot(apart));
      }
    }
    result.greatest[static_cast<std::size_t>(side)] =
        *std::max_element(of_face.begin(), of_face.begin() + polygon.count);
  }
  return result;
}

}  // namespace manifuzz::exact
