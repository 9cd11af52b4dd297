#pragma once

#include <string>
#include <vector>

#include "cli/pages/words_of_help.hpp"

namespace manifuzz {

/// What shells complete commands, options and values by: a script that bash, zsh or fish reads.
/// Values that `manifuzz list` knows are asked of the program when they are completed.
std::string bash_completion(const std::vector<CommandWords>& program);
std::string zsh_completion(const std::vector<CommandWords>& program);
std::string fish_completion(const std::vector<CommandWords>& program);

}  // namespace manifuzz
