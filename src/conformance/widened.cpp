#include "conformance/widened.hpp"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "base/text.hpp"

namespace manifuzz {

Declaration port_declaration(ScalarType scalar) {
  return {.name = "port", .scalar = scalar};
}

std::string_view scalar_key(ScalarType scalar) {
  return scalar == ScalarType::float32 ? "float32" : "float64";
}

void append_widened(std::string& out, double bound) {
  constexpr double kHalfOfLastDigit = 5.1e-5;
  const std::string five_digits = fmt::format("{:.4e}", bound * (1 + kHalfOfLastDigit));
  append_number(out, std::strtod(five_digits.c_str(), nullptr));
}

double lost_in_writing(double figure) {
  return 0x1p-52 * std::abs(figure);
}

}  // namespace manifuzz
