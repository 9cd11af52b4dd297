#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace manifuzz {

// What embed.cmake makes of the files that texts.txt lists.

/// What `glossary` gives: "word: meaning", a line each.
extern const std::string_view kGlossary;

/// The page's one HTML file, in which `@style@`, `@data@` and `@script@` stand once each for what
/// goes there.
extern const std::string_view kPageTemplate;
/// Its style sheets, one after the other.
extern const std::string_view kPageStyle;
/// Its scripts, one after the other: one module.
extern const std::string_view kPageScript;

/// The style sheet of all pictures of a case: blue and orange, told apart by every eye (Okabe and
/// Ito); what colliders say is red or green.
extern const std::string_view kPictureStyle;
/// What a filmstrip has besides.
extern const std::string_view kFilmstripStyle;

struct Word {
  std::string_view word;
  std::string_view meaning;
};

/// The words that tables, pages and files use, in the order in which they explain each other.
std::vector<Word> glossary();

/// All of them as text, for a terminal.
std::string glossary_text();

}  // namespace manifuzz
