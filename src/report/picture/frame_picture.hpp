#pragma once

#include <span>
#include <string>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A contact point in the world.
struct FramePoint {
  Vector2<double> position;
  Vector2<double> normal;  ///< unit
};

/// Bodies and the points where they touch, with their normals, as an SVG document.
std::string frame_svg(std::span<const Body> bodies, std::span<const FramePoint> points,
                      std::string_view title);

}  // namespace manifuzz
