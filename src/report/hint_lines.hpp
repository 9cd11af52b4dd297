#pragma once

#include <span>
#include <string>

#include "campaign/hints/hint.hpp"

namespace manifuzz {

/// "hint: ...", a line each; nothing where there is none.
std::string hint_lines(std::span<const Hint> hints);

}  // namespace manifuzz
