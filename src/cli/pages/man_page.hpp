#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/pages/words_of_help.hpp"

namespace manifuzz {

/// The program's page for man(1), as groff reads it.
std::string man_page(const std::vector<CommandWords>& program, std::string_view version);

}  // namespace manifuzz
