#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace manifuzz {

/// Appends the shortest decimal that reads back bit for bit, read to the nearest double and then to
/// the nearest float; "null" where the number is not finite, which JSON cannot say.
void append_number(std::string& out, float value);
void append_number(std::string& out, double value);

/// Appends a JSON string, quotes included. Bytes that are not UTF-8 become U+FFFD.
void append_string(std::string& out, std::string_view text);

/// `text` fit for an error line: printable ASCII as it is, every other byte as \xNN, shortened to
/// `longest` characters.
std::string printable(std::string_view text, std::size_t longest = 40);

/// As one word of a shell's command line: in single quotes where it needs them.
std::string quoted_for_shell(std::string_view text);

}  // namespace manifuzz
