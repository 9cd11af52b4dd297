#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/json.hpp"
#include "campaign/result.hpp"

namespace manifuzz {

// Counts and texts of a result's JSON. Each throws UserError that begins with a path.

/// A whole number up to kCountMax.
inline std::uint64_t count_in(const JsonView& object, std::string_view key) {
  const JsonView member = object.at(key);
  const std::uint64_t count = member.whole_number();
  if (count <= kCountMax) return count;
  member.fail(fmt::format("{} is no count; at most {} is expected", count, kCountMax));
}

inline std::uint64_t count_or(const JsonView& object, std::string_view key,
                              std::uint64_t otherwise) {
  return object.find(key) ? count_in(object, key) : otherwise;
}

inline bool flag_in(const JsonView& object, std::string_view key) {
  const auto member = object.find(key);
  return member && member->boolean();
}

/// Counts by name, as of regimes.
inline std::map<std::string, std::uint64_t> read_counts(const JsonView& object) {
  std::map<std::string, std::uint64_t> counts;
  for (const std::string_view name : object.keys()) counts.emplace(name, count_in(object, name));
  return counts;
}

/// None where the key is missing.
inline std::map<std::string, std::uint64_t> counts_or_none(const JsonView& object,
                                                           std::string_view key) {
  const auto member = object.find(key);
  return member ? read_counts(*member) : std::map<std::string, std::uint64_t>{};
}

inline std::vector<std::string> read_texts(const JsonView& list) {
  std::vector<std::string> texts;
  for (const JsonView& text : list.elements()) texts.emplace_back(text.string());
  return texts;
}

}  // namespace manifuzz
