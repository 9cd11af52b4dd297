#include "conformance/widened.hpp"

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

namespace {

/// With so many digits behind the first.
void append_rounded(std::string& out, double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits);
  append_number(out, std::strtod(text.c_str(), nullptr));
}

}  // namespace

void append_widened(std::string& out, double bound) {
  constexpr double kHalfOfLastDigit = 5.1e-7;
  append_rounded(out, bound * (1 + kHalfOfLastDigit), 6);
}

void append_low(std::string& out, const exact::DoubleDouble& figure) {
  append_rounded(out, figure.low, 2);
}

}  // namespace manifuzz
