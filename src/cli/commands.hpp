#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include <CLI/CLI.hpp>

namespace manifuzz {

/// What a command does once its options are read: returns 0 (all well), 1 (it found something) or
/// throws UserError (status 2).
using Run = std::function<int()>;

/// A command as the list of them has it.
struct Command {
  std::string_view name;
  std::string_view summary;  ///< one sentence, for the list of commands and for its own help
  std::string_view example;  ///< command lines that work when pasted, below its help
  Run (*define)(
      CLI::App& app);  ///< null where it is manifuzz-measure's, and this is another program
};

/// Such a `define`: `add` adds options, which `run` gets as they were read. One with `ci` among
/// its options tells CI what it throws.
template <class Options, auto add, auto run>
Run define(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  add(app, *options);
  return [options, name = app.get_name()] {
    if constexpr (requires { options->ci; }) {
      return run_for_ci(name, options->ci, [&] { return run(*options); });
    } else {
      return run(*options);
    }
  };
}

/// Every command, in the order of the help.
std::span<const Command> commands();

}  // namespace manifuzz
