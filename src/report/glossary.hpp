#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace manifuzz {

/// The words that tables, pages and files use, each with what it means, in the order in which they
/// explain each other.
std::span<const std::pair<std::string_view, std::string_view>> glossary();

/// All of them as text, for a terminal.
std::string glossary_text();

}  // namespace manifuzz
