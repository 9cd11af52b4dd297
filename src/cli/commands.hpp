#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace CLI {
class App;
}

namespace manifuzz {

/// What a command does once its options are read: returns 0 (all well), 1 (it found something) or
/// throws UserError (status 2).
using Run = std::function<int()>;

struct Command {
  std::string_view name;
  std::string_view summary;  ///< one sentence, for the list of commands and for its own help
  std::string_view example;  ///< command lines that work when pasted, below its help
  Run (*define)(CLI::App& app);
};

/// Every command, in the order of the help. Each lives in a file of its own.
std::span<const Command> commands();

}  // namespace manifuzz
