#pragma once

#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace manifuzz {

/// What is wrong with a command line that could not be parsed, and what would be right: one line
/// that names the nearest command or option.
std::string complaint_about_usage(const CLI::App& app, const CLI::ParseError& error);

/// What every command takes, before its name or behind it: --quiet, --no-color.
void add_common_options(CLI::App& app);
/// Makes them hold, wherever they were given, and even where the rest could not be parsed.
void obey_common_options(const CLI::App& app);

/// Below a command's help: its example, indented, a command line each.
std::string help_on_example(std::string_view example);

}  // namespace manifuzz
