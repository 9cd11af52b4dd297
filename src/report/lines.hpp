#pragma once

#include <string>

namespace manifuzz {

/// What `line_of` says of each of a list, one after the other.
std::string lines_of(const auto& list, const auto& line_of) {
  std::string lines;
  for (const auto& one : list) lines += line_of(one);
  return lines;
}

}  // namespace manifuzz
