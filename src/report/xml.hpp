#pragma once

#include <string>
#include <string_view>

namespace manifuzz {

/// `text` fit for an XML attribute or element; control characters become blanks, bytes that
/// are not UTF-8 U+FFFD.
std::string escape_xml(std::string_view text);

}  // namespace manifuzz
