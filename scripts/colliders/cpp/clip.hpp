#pragma once

#include <array>
#include <span>

#include "clipping/collide.hpp"
#include "manifuzz_collider.h"

// The article's clipping in float between manifuzz_collider.h's bodies and manifolds.

namespace clip {

using manifuzz::Vector2;
using Shape = manifuzz::ConvexPolygon<float>;

inline Vector2<float> from_c(const manifuzz_float2& v) {
  return {v.x, v.y};
}

inline manifuzz_double2 to_c(const Vector2<float>& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y())};
}

inline Shape shape_of(const manifuzz_body& body) {
  Shape shape;
  shape.count = body.count;
  shape.radius = body.radius;
  shape.rounding = body.round != 0 ? manifuzz::Rounding::round : manifuzz::Rounding::mitre;
  shape.normals[0] = {0, 0};
  for (int i = 0; i < body.count; ++i) {
    shape.vertices[i] = from_c(body.vertices[i]);
    shape.normals[i] = from_c(body.normals[i]);
  }
  return shape;
}

inline manifuzz::Pose<float> pose_of(const manifuzz_body& body) {
  return {from_c(body.position), from_c(body.rotation)};
}

inline manifuzz_feature to_c(const manifuzz::Feature& feature) {
  const bool is_face = feature.kind == manifuzz::Feature::Kind::face;
  return {static_cast<std::uint8_t>(is_face ? MANIFUZZ_FACE : MANIFUZZ_VERTEX), feature.index};
}

/// Of circles, capsules and polygons of every kind; in A's frame.
inline void collide(const manifuzz_body& a, const manifuzz_body& b, manifuzz_manifold& manifold) {
  const auto found = manifuzz::clipping::collide(shape_of(a), shape_of(b),
                                                 relative_pose(pose_of(a), pose_of(b)));
  manifold.count = found.count;
  manifold.reference = found.reference == manifuzz::Side::a ? MANIFUZZ_A : MANIFUZZ_B;
  manifold.normal = to_c(found.normal);
  for (int i = 0; i < found.count; ++i) {
    const auto& point = found.points[i];
    manifold.points[i] = {to_c(point.position), static_cast<double>(point.depth),
                          to_c(point.features.a), to_c(point.features.b)};
  }
}

/// What it declares, under a name.
inline manifuzz_declaration declaration(const char* name) {
  manifuzz_declaration declared{};
  declared.interface = MANIFUZZ_INTERFACE;
  declared.name = name;
  declared.version = "1";
  declared.scalar = MANIFUZZ_FLOAT32;
  declared.rounds_in = MANIFUZZ_FRAME_OF_A;
  declared.answers_in = MANIFUZZ_FRAME_OF_A;
  declared.vertices_max = MANIFUZZ_VERTICES_MAX;
  declared.takes_radius = 1;
  declared.claims.vertices_min = 1;
  declared.claims.takes_round = 1;
  return declared;
}

}  // namespace clip
