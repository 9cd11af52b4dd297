#include "oracle/box2d3/placed.hpp"

#include <cmath>

namespace manifuzz {
namespace {

using exact::RoughPolygon;

/// The shape as the adapter hands it over; a capsule's normals are b2MakeCapsule's.
RoughPolygon handed_over(const ConvexPolygon<float>& polygon, double length) {
  RoughPolygon made{};
  made.count = polygon.count;
  for (int i = 0; i < made.count; ++i) {
    made.vertices[i] = length * polygon.vertices[i].cast<double>();
  }
  for (int i = 0; i < made.count; ++i) {
    const Vector2<double> along =
        polygon.vertices[made.next(i)].cast<double>() - polygon.vertices[i].cast<double>();
    made.normals[i] = Vector2<double>(along.y(), -along.x()) / along.norm();
  }
  if (made.count == 2) {
    const Vector2<double> along = made.vertices[1] - made.vertices[0];
    const Vector2<double> axis = 1.0 / along.norm() * along;
    made.normals[0] = {axis.y(), -axis.x()};
    made.normals[1] = -made.normals[0];
  }
  return made;
}

}  // namespace

UnitRotation unit_rotation(const Pose<float>& pose) {
  const Vector2<double> stored = pose.rotation.cast<double>();
  const double length = std::sqrt(stored.x() * stored.x() + stored.y() * stored.y());
  return {stored / length, length};
}

PlacedByPhaser placed_by_phaser(const PairCase& pair) {
  const bool is_swapped = pair.a.polygon.count == 2 && pair.b.polygon.count > 2;
  const Body& first = is_swapped ? pair.b : pair.a;
  const Body& second = is_swapped ? pair.a : pair.b;
  const UnitRotation of_first = unit_rotation(first.pose);
  const UnitRotation of_second = unit_rotation(second.pose);
  PlacedByPhaser placed{.first = handed_over(first.polygon, of_first.length),
                        .second = handed_over(second.polygon, of_second.length),
                        .is_swapped = is_swapped,
                        .rotation = of_first.unit};
  const Vector2<double> origin = placed.first.vertices[0];
  const Vector2<double> at =
      first.pose.position.cast<double>() + rotate<double>(of_first.unit, origin);
  const Vector2<double> turn = rotate_back<double>(of_first.unit, of_second.unit);
  const Vector2<double> shift =
      rotate_back<double>(of_first.unit, second.pose.position.cast<double>() - at);
  for (int i = 0; i < placed.first.count; ++i) placed.first.vertices[i] -= origin;
  for (int i = 0; i < placed.second.count; ++i) {
    placed.second.vertices[i] = rotate<double>(turn, placed.second.vertices[i]) + shift;
    placed.second.normals[i] = rotate<double>(turn, placed.second.normals[i]);
  }
  return placed;
}

}  // namespace manifuzz
