#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace manifuzz {

/// The candidate that was most likely meant by `word`: the only one that begins with it, else the
/// first of those with the fewest slips (a character too many, missing, another, or two swapped),
/// at most one in three characters. Nothing where none is that near.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

/// "; did you mean 'sliver'?", or nothing where no candidate is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// "there is no regime 'slivr'; did you mean 'sliver'?", then what there is, unless that is long
/// and the nearest was named.
std::string no_such(std::string_view kind, std::string_view word,
                    std::span<const std::string_view> candidates);

}  // namespace manifuzz
