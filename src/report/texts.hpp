#pragma once

#include <string_view>

namespace manifuzz {

// What src/embed.cmake makes of the files that texts.txt lists.

/// What glossary.hpp gives: "word: meaning", a line each.
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

}  // namespace manifuzz
