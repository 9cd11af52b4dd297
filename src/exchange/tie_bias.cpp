#include <fmt/format.h>

#include "base/json.hpp"
#include "exchange/json.hpp"

namespace manifuzz {

Side read_side(const JsonView& value) {
  const std::string_view name = value.string();
  if (name != "a" && name != "b") value.fail("\"a\" or \"b\" is expected");
  return name == "a" ? Side::a : Side::b;
}

TieBias read_tie_bias(const JsonView& value) {
  if (!value.is_object()) return {.absolute = value.magnitude()};
  value.expect_keys({"absolute", "relative", "towards"});
  TieBias bias;
  if (const auto absolute = value.find("absolute")) bias.absolute = absolute->magnitude();
  if (const auto relative = value.find("relative")) bias.relative = relative->number();
  if (!value.find("absolute") && !value.find("relative")) {
    value.fail("\"absolute\" or \"relative\" is expected");
  }
  if (const auto towards = value.find("towards")) bias.towards = read_side(*towards);
  return bias;
}

std::string in_words(const TieBias& bias) {
  if (bias == TieBias{.absolute = bias.absolute}) return fmt::format("{}", bias.absolute);
  return fmt::format("{} and {}% towards {}", bias.absolute, 100 * bias.relative,
                     bias.towards == Side::a ? 'a' : 'b');
}

}  // namespace manifuzz
