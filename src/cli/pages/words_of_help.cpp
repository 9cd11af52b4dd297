#include "cli/pages/words_of_help.hpp"

#include <algorithm>
#include <set>
#include <string_view>

namespace manifuzz {
namespace {

struct ListOfValues {
  std::string_view name;  ///< of an option, or of an argument
  std::string_view command;
};

/// What `manifuzz list` knows the values of.
constexpr ListOfValues kListsOfValues[] = {{"--subject", "manifuzz list colliders"},
                                           {"--oracle", "manifuzz list colliders"},
                                           {"--collider", "manifuzz list colliders"},
                                           {"--regime", "manifuzz list regimes"},
                                           {"--sweep", "manifuzz list sweeps"},
                                           {"--scene", "manifuzz list scenes"},
                                           {"WHAT", "manifuzz list"}};

std::string list_of_values(const OptionWords& words) {
  if (words.value.starts_with("LIBRARY")) return {};  // a path alone, and no name
  for (const auto& [name, command] : kListsOfValues) {
    const bool is_option = std::ranges::find(words.names, name) != words.names.end();
    if (is_option || words.argument == name) return std::string(command);
  }
  return {};
}

/// Names in the order of the help, which that of a set of pointers is not.
std::vector<std::string> names_of_options(const CLI::App& app, const std::set<CLI::Option*>& of) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options()) {
    if (of.contains(const_cast<CLI::Option*>(option))) names.push_back(option->get_name());
  }
  return names;
}

/// The choices in a type as CLI11 shows it, "M:{strict,recycle}".
std::vector<std::string> choices_in(std::string_view type) {
  const auto open = type.find('{');
  if (open == type.npos || !type.ends_with('}')) return {};
  return CLI::detail::split(std::string(type.substr(open + 1, type.size() - open - 2)), ',');
}

OptionWords words_of(const CLI::App& app, const CLI::Option& option) {
  OptionWords words;
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  if (words.names.empty()) words.argument = option.get_name(true);
  const bool takes_value = option.get_items_expected_max() > 0;
  const std::string type = takes_value ? option.get_type_name() : "";
  words.value = type.substr(0, type.find(':'));
  words.text = option.get_description();
  words.choices = choices_in(type);
  words.values_from = list_of_values(words);
  words.needs = names_of_options(app, option.get_needs());
  words.excludes = names_of_options(app, option.get_excludes());
  words.is_required = option.get_required();
  words.is_repeatable = option.get_items_expected_max() > 1;
  return words;
}

CommandWords words_of(const CLI::App& app, const std::string& name) {
  CommandWords words{name, app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* const option : app.get_options()) {
    const OptionWords one = words_of(app, *option);
    (one.names.empty() ? words.arguments : words.options).push_back(one);
  }
  return words;
}

}  // namespace

std::vector<CommandWords> words_of_help(const CLI::App& app) {
  std::vector<CommandWords> all{words_of(app, "")};
  for (const CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; })) {
    all.push_back(words_of(*command, command->get_name()));
  }
  return all;
}

}  // namespace manifuzz
