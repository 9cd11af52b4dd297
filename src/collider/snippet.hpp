#pragma once

#include <array>
#include <string_view>

namespace manifuzz {

/// What a snippet's template may ask for of either body; src/external/README.md says what each
/// is.
inline constexpr std::array<std::string_view, 14> kSnippetKeys{
    "vertices",    "normals",  "position",      "rotation",      "radius",
    "count",       "world",    "unit_vertices", "unit_rotation", "unit_normals",
    "wide_radius", "centroid", "reach",         "wide_reach"};

/// On what a line of it may depend.
inline constexpr std::array<std::string_view, 7> kSnippetConditions{
    "circle", "segment", "polygon", "rounded", "moved", "turned", "placed"};

}  // namespace manifuzz
