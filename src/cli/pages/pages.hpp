#pragma once

#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace manifuzz {

/// Whether `--help NAME` prints a page about all of the program: words, man, bash, zsh or fish.
bool is_page(std::string_view name);

/// Whether such a page has every option, those of manifuzz-measure, too.
bool has_all_options(std::string_view name);

/// The page; `app` has every command.
std::string page(const CLI::App& app, std::string_view name);

}  // namespace manifuzz
