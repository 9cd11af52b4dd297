#include "report/markdown.hpp"

#include <fmt/format.h>

namespace manifuzz {

std::string escape_markdown(std::string_view text) {
  constexpr std::string_view special = "\\`*_{}[]<>()#|~&$@!";
  std::string out;
  for (const char c : text) {
    if (special.find(c) != special.npos) out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out;
}

std::string code_block(std::string_view text, std::string_view language) {
  std::string fence = "```";
  while (text.find(fence) != text.npos) fence += '`';
  const std::string_view end = text.ends_with('\n') ? "" : "\n";
  return fmt::format("{}{}\n{}{}{}\n", fence, language, text, end, fence);
}

}  // namespace manifuzz
