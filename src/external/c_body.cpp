#include "external/c_body.hpp"

namespace manifuzz {
namespace {

manifuzz_float2 to_c(const Vector2<float>& v) {
  return {v.x(), v.y()};
}

manifuzz_double2 to_c(const Vector2<double>& v) {
  return {v.x(), v.y()};
}

}  // namespace

manifuzz_body c_body(const Body& body) {
  const ConvexPolygon<double> in_double = polygon_cast<double>(body.polygon);
  manifuzz_body result{};
  result.count = body.polygon.count;
  for (int i = 0; i < body.polygon.count; ++i) {
    result.vertices[i] = to_c(body.polygon.vertices[i]);
    result.normals[i] = to_c(body.polygon.normals[i]);
    result.normals_double[i] = to_c(in_double.normals[i]);
  }
  result.radius = body.polygon.radius;
  result.position = to_c(body.pose.position);
  result.rotation = to_c(body.pose.rotation);
  result.round = body.polygon.is_round() ? 1 : 0;
  return result;
}

}  // namespace manifuzz
