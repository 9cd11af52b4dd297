#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace manifuzz {

/// An option, or an argument, as the help of its command has it.
struct OptionWords {
  std::vector<std::string> names;    ///< as they are written, "--seed"; none of an argument
  std::string argument;              ///< the name of an argument; empty for an option
  std::string value;                 ///< what stands for its value, "FILE"; empty for a flag
  std::string text;                  ///< what it does
  std::vector<std::string> choices;  ///< all values that it takes, where they are few
  std::string values_from;  ///< the command that lists its values, each with more behind it
  std::vector<std::string> needs;
  std::vector<std::string> excludes;
  bool is_required = false;
  bool is_repeatable = false;

  bool takes_folder() const { return value == "DIR" && argument.empty(); }
  /// Arguments that are folders may be files, too.
  bool takes_path() const {
    return value.starts_with("FILE") || value == "PATH" || (value == "DIR" && !takes_folder());
  }
  /// Whether a file is one of what it takes.
  bool may_take_path() const { return takes_path() || value.find("LIBRARY") != value.npos; }
};

/// A command, or the program itself, whose `name` is empty.
struct CommandWords {
  std::string name;
  std::string summary;
  std::string footer;
  std::vector<OptionWords> options;
  std::vector<OptionWords> arguments;
};

/// What `--help` says: the program first, then its commands in their order.
std::vector<CommandWords> words_of_help(const CLI::App& app);

}  // namespace manifuzz
