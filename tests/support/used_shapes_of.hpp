#pragma once

#include <algorithm>

#include "collider/used_shapes.hpp"

namespace manifuzz::test {

/// The polygon as a collider has it that alters nothing.
inline UsedVertices used_vertices_of(const ConvexPolygon<float>& polygon) {
  UsedVertices used;
  used.count = polygon.count;
  std::ranges::transform(polygon.corners(), used.all.begin(),
                         [](const auto& v) { return v.template cast<double>(); });
  return used;
}

inline UsedShapes used_shapes_of(const PairCase& pair) {
  return {used_vertices_of(pair.a.polygon), used_vertices_of(pair.b.polygon)};
}

}  // namespace manifuzz::test
