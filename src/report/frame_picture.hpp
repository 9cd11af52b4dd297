#pragma once

#include <span>
#include <string>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// Bodies and the points where they touch, both in the world, as an SVG document.
std::string frame_svg(std::span<const Body> bodies, std::span<const Vector2<double>> contacts,
                      std::string_view title);

}  // namespace manifuzz
