#include "base/text.hpp"

#include <charconv>
#include <cmath>
#include <iterator>

#include <fmt/compile.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace manifuzz {
namespace {

/// Whether JSON has other words for it than fmt; those are appended.
bool append_special(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return true;
  }
  if (value == 0 && std::signbit(value)) {
    out += "-0.0";  // "-0" is an integer to many readers, and integers have no sign of zero
    return true;
  }
  return false;
}

}  // namespace

std::string quoted_for_shell(std::string_view text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

void append_number(std::string& out, double value) {
  if (append_special(out, value)) return;
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), value);
}

void append_number(std::string& out, float value) {
  if (append_special(out, value)) return;
  const std::size_t start = out.size();
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), value);
  double read = 0;
  std::from_chars(out.data() + start, out.data() + out.size(), read);
  if (static_cast<float>(read) == value) return;
  out.resize(start);  // rounded twice, a few floats' shortest decimals end up beside them
  append_number(out, static_cast<double>(value));
}

void append_string(std::string& out, std::string_view text) {
  constexpr auto replace = nlohmann::json::error_handler_t::replace;
  out += nlohmann::json(text).dump(-1, ' ', false, replace);
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string out;
  for (const char c : text) {
    if (out.size() >= longest) return out + "...";
    if (c >= ' ' && c <= '~') {
      out += c;
    } else {
      fmt::format_to(std::back_inserter(out), "\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

}  // namespace manifuzz
