#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace manifuzz {

/// A word, and what it means here.
struct Word {
  std::string_view word;
  std::string_view meaning;
};

/// The words that tables, pages and files use, in the order in which they explain each other.
std::vector<Word> glossary();

/// All of them as text, for a terminal.
std::string glossary_text();

}  // namespace manifuzz
