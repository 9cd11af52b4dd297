#pragma once

#include <array>
#include <string>
#include <string_view>

#include "collider/collider.hpp"

namespace manifuzz {

/// A collider that clips, as the suite judges ports: it rounds in A's frame and has no bias.
Declaration port_declaration(ScalarType scalar);

inline constexpr std::array kScalars{ScalarType::float32, ScalarType::float64};

/// "float32" or "float64", a key of what is right in that scalar.
std::string_view scalar_key(ScalarType scalar);

/// Appends a bound of five digits, rounded up.
void append_widened(std::string& out, double bound);

/// What a figure of that size loses where it is written as a double, and another one is subtracted
/// from it.
double lost_in_writing(double figure);

}  // namespace manifuzz
