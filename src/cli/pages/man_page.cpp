#include "cli/pages/man_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/glossary.hpp"

namespace manifuzz {
namespace {

/// Text that groff prints as it stands: no request at the beginning of a line, no escape, and the
/// hyphens that a reader can paste.
std::string as_groff(std::string_view text) {
  std::string result;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) result += "\\&";
    switch (c) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '\'':
        result += "\\(aq";
        break;
      case '`':
        result += "\\(ga";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      default:
        result += c;
    }
    begins_line = c == '\n';
  }
  return result;
}

std::string without_period(std::string_view sentence) {
  if (sentence.ends_with('.')) sentence.remove_suffix(1);
  return std::string(sentence);
}

/// "; needs --seed, --cases".
std::string other_options(std::string_view verb, const std::vector<std::string>& names) {
  return names.empty() ? "" : fmt::format("; {} {}", verb, fmt::join(names, ", "));
}

std::string entry(const OptionWords& option) {
  std::string head;
  for (const std::string& name : option.names) {
    head += fmt::format("{}\\fB{}\\fR", head.empty() ? "" : ", ", as_groff(name));
  }
  if (!option.argument.empty()) head = fmt::format("\\fI{}\\fR", as_groff(option.argument));
  if (option.argument.empty() && !option.value.empty()) {
    head += fmt::format(" \\fI{}\\fR", as_groff(option.value));
  }
  std::string text = option.text;
  if (!option.choices.empty()) text += fmt::format("; one of {}", fmt::join(option.choices, ", "));
  text += other_options("needs", option.needs) + other_options("not with", option.excludes);
  return fmt::format(".TP\n{}\n{}\n", head, as_groff(text));
}

std::string entries(const CommandWords& command) {
  std::string text;
  for (const OptionWords& argument : command.arguments) text += entry(argument);
  for (const OptionWords& option : command.options) text += entry(option);
  return text;
}

/// "manifuzz show [OPTION...] file".
std::string usage(const CommandWords& command) {
  std::string line = fmt::format("\\fBmanifuzz {}\\fR [\\fIOPTION\\fR...]", command.name);
  for (const OptionWords& argument : command.arguments) {
    const std::string name =
        fmt::format("\\fI{}\\fR{}", argument.argument, argument.is_repeatable ? "..." : "");
    line += argument.is_required ? " " + name : fmt::format(" [{}]", name);
  }
  return line;
}

std::string section(const CommandWords& command) {
  return fmt::format(".SS {}\n{}\n.PP\n{}\n{}.PP\n.nf\n{}.fi\n", command.name,
                     as_groff(command.summary), usage(command), entries(command),
                     as_groff(command.footer));
}

}  // namespace

std::string man_page(const std::vector<CommandWords>& program, std::string_view version) {
  const CommandWords& itself = program.front();
  std::string page =
      fmt::format(".TH MANIFUZZ 1 \"\" \"manifuzz {}\" \"User Commands\"\n", as_groff(version));
  page += fmt::format(".SH NAME\nmanifuzz, manifuzz\\-measure \\- {}\n",
                      as_groff(without_period(itself.summary)));
  page += ".SH SYNOPSIS\n\\fBmanifuzz\\fR [\\fIOPTION\\fR...] \\fICOMMAND\\fR ...\n";
  page += ".SH OPTIONS\n" + entries(itself);
  page += ".SH COMMANDS\n";
  for (std::size_t i = 1; i < program.size(); ++i) page += section(program[i]);
  page +=
      ".SH EXIT STATUS\n.TP\n0\nall is well\n.TP\n1\nsomething was found\n"
      ".TP\n2\nbad usage or input, which a line says; or a result could not be written\n"
      ".TP\n130, 143\ninterrupted, and what was found until then is saved\n";
  page += ".SH WORDS\n";
  for (const Word& word : glossary()) {
    page += fmt::format(".TP\n{}\n{}\n", as_groff(word.word), as_groff(word.meaning));
  }
  return page;
}

}  // namespace manifuzz
