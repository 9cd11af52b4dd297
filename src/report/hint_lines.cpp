#include "report/hint_lines.hpp"

#include <fmt/format.h>

#include "report/outputs.hpp"

namespace manifuzz {

std::string hint_lines(std::span<const Hint> hints) {
  std::string text;
  for (const Hint& hint : hints) {
    text += fmt::format("{}: {}\n", fresh("hint"), hint.text);
  }
  return text;
}

}  // namespace manifuzz
