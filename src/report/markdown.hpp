#pragma once

#include <string>
#include <string_view>

namespace manifuzz {

/// Text as Markdown that shows it as it is, in one line.
std::string escape_markdown(std::string_view text);

/// A block of code that `text` cannot end, whatever it holds.
std::string code_block(std::string_view text, std::string_view language);

}  // namespace manifuzz
