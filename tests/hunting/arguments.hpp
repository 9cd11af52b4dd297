#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace manifuzz::test {

/// The whole number that an argument of a program is, in digits alone; none where it is not one.
inline std::optional<std::uint64_t> number_in(std::string_view text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

}  // namespace manifuzz::test
