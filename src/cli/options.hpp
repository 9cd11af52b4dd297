#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace manifuzz {

/// An option that takes a whole number from `least` to 2^64 - 1. CLI11's own reading takes -1 for
/// 2^64 - 1 and 010 for 8.
CLI::Option* add_whole_number(CLI::App& app, const std::string& name,
                              std::optional<std::uint64_t>& to, const std::string& description,
                              std::uint64_t least = 0);

/// An option that takes a finite number, 0 or more.
CLI::Option* add_length(CLI::App& app, const std::string& name, std::optional<double>& to,
                        const std::string& description);

/// A check that an option's text is not blank: what is wrong, or nothing.
std::string not_blank(const std::string& text);

/// The seed that was given, or one that is drawn and printed on stderr first.
std::uint64_t seed_or_draw(const std::optional<std::uint64_t>& seed);

}  // namespace manifuzz
