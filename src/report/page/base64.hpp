#pragma once

#include <string>
#include <string_view>

namespace manifuzz {

/// Bytes as text, after RFC 4648.
std::string base64(std::string_view bytes);

}  // namespace manifuzz
