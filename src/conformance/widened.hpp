#pragma once

#include <array>
#include <string>
#include <string_view>

#include "collider/collider.hpp"
#include "exact/arithmetic.hpp"

namespace manifuzz {

/// A collider that clips, as the suite judges ports: it rounds in A's frame and has no bias.
Declaration port_declaration(ScalarType scalar);

inline constexpr std::array kScalars{ScalarType::float32, ScalarType::float64};

/// "float32" or "float64", a key of what is right in that scalar.
std::string_view scalar_key(ScalarType scalar);

/// Appends a bound of seven digits, rounded up: an answer is decided as the judge decides it unless
/// it is beyond its bound by less than a millionth of that.
void append_widened(std::string& out, double bound);

/// Appends what a figure lost where it was written as a double: a checker that subtracts it too
/// compares with the figure itself. To three digits.
void append_low(std::string& out, const exact::DoubleDouble& figure);

}  // namespace manifuzz
