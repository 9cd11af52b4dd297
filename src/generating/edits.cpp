#include "generating/edits.hpp"

#include <cmath>

namespace manifuzz {
namespace {

bool is_valid(const Body& body) {
  return !find_defect(body.polygon.corners()) && body.pose.position.allFinite() &&
         body.pose.rotation.allFinite() && is_unit_rotation(body.pose.rotation) &&
         std::isfinite(body.polygon.radius) && body.polygon.radius >= 0;
}

}  // namespace

std::vector<float*> free_numbers(PairCase& pair) {
  std::vector<float*> numbers;
  for (const Side side : {Side::a, Side::b}) {
    Body& body = pair[side];
    for (int i = 0; i < body.polygon.count; ++i) {
      numbers.push_back(&body.polygon.vertices[i].x());
      numbers.push_back(&body.polygon.vertices[i].y());
    }
    numbers.push_back(&body.pose.position.x());
    numbers.push_back(&body.pose.position.y());
    numbers.push_back(&body.polygon.radius);
  }
  return numbers;
}

std::optional<PairCase> revalidated(PairCase pair) {
  for (const Side side : {Side::a, Side::b}) {
    Body& body = pair[side];
    if (!is_valid(body)) return std::nullopt;
    body.polygon = make_polygon(body.polygon.corners(), body.polygon.radius);
  }
  return pair;
}

}  // namespace manifuzz
