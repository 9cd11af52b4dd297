#include "cli/usage.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/names.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

bool is_option(const std::string& word) {
  return word.starts_with('-') && word != "-";
}

/// The first that looks like an option, which is the one to blame for the words behind it; else the
/// first, or nothing.
std::string one_to_blame(const std::vector<std::string>& words) {
  const auto option = std::ranges::find_if(words, is_option);
  if (option != words.end()) return option->substr(0, option->find('='));
  return words.empty() ? "" : words.front();
}

std::string no_such_option(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  return fmt::format("there is no option '{}'{}", printable(word), did_you_mean(word, known));
}

std::string no_such_command(const std::string& word) {
  std::vector<std::string_view> names;
  for (const Command& command : commands()) names.push_back(command.name);
  return no_such("command", word, names);
}

std::string with_help_of(std::string what, std::string_view command) {
  what += what.ends_with('?') ? " Try" : "; try";
  return fmt::format("{} manifuzz {}{}--help", what, command, command.empty() ? "" : " ");
}

std::string complaint_about_command(const CLI::App& app) {
  const std::string word = one_to_blame(app.remaining());
  if (word.empty()) return with_help_of("a command is missing", "");
  return with_help_of(is_option(word) ? no_such_option(app, word) : no_such_command(word), "");
}

}  // namespace

std::string complaint_about_usage(const CLI::App& app, const CLI::ParseError& error) {
  const auto used = app.get_subcommands();
  if (used.empty()) return complaint_about_command(app);
  const CLI::App& command = *used[0];
  const std::string word = one_to_blame(command.remaining());
  const bool is_word_too_many = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  // What an option is missing may be what a misspelt one has taken.
  const std::string what = is_option(word) ? no_such_option(command, word)
                           : is_word_too_many
                               ? fmt::format("'{}' is a word too many", printable(word))
                               : printable(error.what(), 300);
  return fmt::format("{}: {}", command.get_name(), with_help_of(what, command.get_name()));
}

void add_common_options(CLI::App& app) {
  const std::string quiet =
      "no progress, no remarks; unsaid is what is well, and what a file says in its place";
  const std::string plain = "no colours on a terminal; NO_COLOR in the environment does the same";
  app.add_flag("--quiet", quiet);
  app.add_flag("--no-color", plain);
}

void obey_common_options(const CLI::App& app) {
  const auto is_given = [&app](const char* name) {
    const auto commands_used = app.get_subcommands();
    return app.count(name) > 0 || std::ranges::any_of(commands_used, [name](const CLI::App* used) {
             return used->count(name) > 0;
           });
  };
  if (is_given("--quiet")) be_quiet();
  if (!is_given("--no-color")) allow_colours();
}

std::string help_on_example(std::string_view example) {
  std::string text = "Example:\n  ";
  for (const char c : example) {
    text += c;
    if (c == '\n') text += "  ";
  }
  return text + "\n";
}

}  // namespace manifuzz
