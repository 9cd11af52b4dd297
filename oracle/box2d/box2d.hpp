#pragma once

#include "collider/collider.hpp"

namespace manifuzz {

/// Box2D's `b2CollidePolygons` (b2_collide_polygon.cpp), on shapes filled from the stored floats:
/// `b2PolygonShape::Set` would weld, reorder and assert. Its answer is converted without rounding
/// that counts: points from the incident body's frame in double, depths from `b2WorldManifold`.
Collider make_box2d();

/// `b2CollidePolygons` alone, through all pairs once, on shapes and transforms laid out beforehand.
std::function<void()> box2d_pass(std::span<const PairCase> pairs);

}  // namespace manifuzz
