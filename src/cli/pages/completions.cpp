#include "cli/pages/completions.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace manifuzz {
namespace {

std::string all_names(const CommandWords& command) {
  std::string names;
  for (const OptionWords& option : command.options) {
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

std::string names_of_commands(const std::vector<CommandWords>& program) {
  std::string names;
  for (std::size_t i = 1; i < program.size(); ++i) {
    names += (names.empty() ? "" : " ") + program[i].name;
  }
  return names;
}

/// In single quotes, however a shell must be told of one inside.
std::string in_quotes(std::string_view text, std::string_view quote) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'')
      result += quote;
    else
      result += c;
  }
  return result + "'";
}

/// The first line that fits a menu: what comes before the first semicolon or colon.
std::string in_short(std::string_view text) {
  return std::string(text.substr(0, text.find_first_of(";:")));
}

/// How bash finds the values of an option or an argument: assignments, of which the last fills
/// `words`.
std::string bash_values(const OptionWords& option) {
  std::string found;
  if (!option.choices.empty()) found += fmt::format("words='{}'; ", fmt::join(option.choices, " "));
  if (!option.values_from.empty()) {
    found += fmt::format("words=$({} 2>/dev/null | cut -d' ' -f1); ", option.values_from);
  }
  if (option.takes_folder()) found += "kind=directory; ";
  if (option.may_take_path()) found += "kind=file; ";
  return found;
}

/// A case of bash's `case`, for each option of a command that takes a value.
std::string bash_cases_of_values(const CommandWords& command) {
  std::string cases;
  for (const OptionWords& option : command.options) {
    if (option.value.empty()) continue;
    std::string pattern;
    for (const std::string& name : option.names) {
      pattern += fmt::format("{}{}:{}", pattern.empty() ? "" : "|", command.name, name);
    }
    cases += fmt::format("    {}) {}is_value=1 ;;\n", pattern, bash_values(option));
  }
  return cases;
}

std::string bash_case_of_command(const CommandWords& command, const std::string& more_words) {
  std::string found;
  for (const OptionWords& argument : command.arguments) found += bash_values(argument);
  return fmt::format("      '{}') options='{}'; {}{} ;;\n", command.name, all_names(command), found,
                     more_words);
}

}  // namespace

std::string bash_completion(const std::vector<CommandWords>& program) {
  std::string values;
  std::string commands;
  for (const CommandWords& command : program) {
    const bool is_program = command.name.empty();
    values += bash_cases_of_values(command);
    commands += bash_case_of_command(
        command, is_program ? fmt::format("words='{}'", names_of_commands(program)) : "");
  }
  return fmt::format(R"bash(# bash completion for manifuzz, written by: manifuzz --help bash
_manifuzz() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command='' words='' options='' kind='' is_value='' i
  if [[ $word == '=' ]]; then
    word=''
  elif [[ $before == '=' ]]; then
    before=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${{COMP_WORDS[i]}} == -* ]] || {{ command=${{COMP_WORDS[i]}}; break; }}
  done
  COMPREPLY=()
  case $command:$before in
{}  esac
  if [[ -z $is_value ]]; then
    case $command in
{}    esac
    [[ $word != -* ]] || {{ words=$options; kind=''; }}
  fi
  [[ -z $words ]] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  if [[ -n $kind ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -A "$kind" -- "$word")
  fi
}}
complete -F _manifuzz manifuzz
)bash",
                     values, commands);
}

namespace {

/// As _arguments of zsh takes it, in the brackets and between the colons of a specification.
std::string in_specification(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_action(const OptionWords& option) {
  if (!option.choices.empty()) return fmt::format("({})", fmt::join(option.choices, " "));
  if (!option.values_from.empty()) {
    return fmt::format("{{_manifuzz_values {}{}}}", option.values_from,
                       option.may_take_path() ? "; _files" : "");
  }
  if (option.takes_folder()) return "_files -/";
  return option.takes_path() ? "_files" : " ";
}

std::string zsh_value(const OptionWords& option, const std::string& name) {
  return fmt::format(":{}:{}", in_specification(name), zsh_action(option));
}

/// The specifications of a command's options and arguments, quoted, a line each.
std::string zsh_specifications(const CommandWords& command, std::string_view indent) {
  std::string lines;
  const auto add = [&](const std::string& specification) {
    lines += fmt::format(" \\\n{}{}", indent, in_quotes(specification, "'\\''"));
  };
  for (const OptionWords& option : command.options) {
    for (const std::string& name : option.names) {
      const std::string value = option.value.empty() ? "" : zsh_value(option, option.value);
      add(fmt::format("{}{}[{}]{}", option.is_repeatable ? "*" : "", name,
                      in_specification(in_short(option.text)), value));
    }
  }
  for (const OptionWords& argument : command.arguments) {
    const std::string before = argument.is_repeatable ? "*" : argument.is_required ? "1" : "1:";
    add(before + zsh_value(argument, argument.argument));
  }
  return lines;
}

}  // namespace

std::string zsh_completion(const std::vector<CommandWords>& program) {
  std::string names;
  std::string cases;
  for (std::size_t i = 1; i < program.size(); ++i) {
    const CommandWords& command = program[i];
    const std::string named = command.name + ":" + in_short(command.summary);
    names += fmt::format("    {}\n", in_quotes(named, "'\\''"));
    cases += fmt::format("    {}) _arguments -s{} ;;\n", command.name,
                         zsh_specifications(command, "      "));
  }
  return fmt::format(R"zsh(#compdef manifuzz
# zsh completion for manifuzz, written by: manifuzz --help zsh

_manifuzz_values() {{
  local -a values
  values=(${{${{(f)"$("$@" 2>/dev/null)"}}%% *}})
  compadd -a values
}}

_manifuzz_commands() {{
  local -a commands
  commands=(
{}  )
  _describe command commands
}}

_manifuzz() {{
  local context state line
  typeset -A opt_args
  _arguments -s -C{} \
    '1:command:_manifuzz_commands' \
    '*::argument:->argument' && return
  [[ $state == argument ]] || return
  case $words[1] in
{}  esac
}}

_manifuzz "$@"
)zsh",
                     names, zsh_specifications(program.front(), "    "), cases);
}

namespace {

std::string fish_values(const OptionWords& option) {
  std::string text;
  if (!option.choices.empty()) {
    text += fmt::format(" -a '{}'", fmt::join(option.choices, " "));
  }
  if (!option.values_from.empty()) {
    text +=
        fmt::format(" -a \"({} 2>/dev/null | string replace -r ' .*' '')\"", option.values_from);
  }
  if (option.takes_folder()) text += " -a '(__fish_complete_directories)'";
  return text;
}

std::string fish_lines(const CommandWords& command, std::string_view condition) {
  std::string lines;
  for (const OptionWords& option : command.options) {
    std::string line = fmt::format("complete -c manifuzz -n '{}'", condition);
    for (const std::string& name : option.names) {
      line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    if (!option.value.empty()) line += option.may_take_path() ? " -r -F" : " -x";
    lines += fmt::format("{}{} -d {}\n", line, fish_values(option),
                         in_quotes(in_short(option.text), "\\'"));
  }
  for (const OptionWords& argument : command.arguments) {
    const std::string files = argument.takes_path() ? " -F" : fish_values(argument);
    if (!files.empty()) lines += fmt::format("complete -c manifuzz -n '{}'{}\n", condition, files);
  }
  return lines;
}

}  // namespace

std::string fish_completion(const std::vector<CommandWords>& program) {
  std::string text =
      "# fish completion for manifuzz, written by: manifuzz --help fish\ncomplete -c manifuzz -f\n";
  for (const CommandWords& command : program) {
    if (command.name.empty()) {
      text += fish_lines(command, "__fish_use_subcommand");
      continue;
    }
    text += fmt::format("complete -c manifuzz -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        in_quotes(in_short(command.summary), "\\'"));
    text += fish_lines(command, "__fish_seen_subcommand_from " + command.name);
  }
  return text;
}

}  // namespace manifuzz
