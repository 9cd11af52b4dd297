#include "canary/switches.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <vector>

namespace manifuzz::canary {
namespace {

/// What an edit of one line does, as far as a switch is concerned.
enum class Form { statement, variable, condition };

/// A line of the form `head value tail`.
struct Parts {
  std::string head;
  std::string value;
  std::string tail;
};

std::string stripped(const std::string& line) {
  const std::size_t comment = line.find("  //");
  const std::string code = line.substr(0, comment);
  const std::size_t first = code.find_first_not_of(" \n");
  if (first == std::string::npos) return {};
  return code.substr(first, code.find_last_not_of(" \n") + 1 - first);
}

bool is_balanced(const std::string& code) {
  constexpr const char* kPairs[] = {"()", "{}", "[]"};
  return std::ranges::all_of(kPairs, [&](const char* pair) {
    return std::ranges::count(code, pair[0]) == std::ranges::count(code, pair[1]);
  });
}

/// Whether the words before an assignment, an initialiser or a call are a type and a name.
bool is_type_and_name(const std::string& words) {
  constexpr const char* kStatements[] = {"return ", "if ", "for ", "while ", "throw "};
  return words.find(' ') != std::string::npos &&
         std::ranges::none_of(kStatements, [&](auto word) { return words.starts_with(word); }) &&
         std::ranges::all_of(words, [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                  std::string_view("_:<>,&* ").find(c) != std::string_view::npos;
         });
}

bool is_declaration(const std::string& code) {
  return is_type_and_name(code.substr(0, std::min(code.find(" ="), code.find_first_of("({;"))));
}

/// `const auto x = value;`, where the value is an expression.
std::optional<Parts> as_variable(const std::string& code) {
  const std::size_t at = code.find(" = ");
  if (at == std::string::npos || !is_type_and_name(code.substr(0, at))) return std::nullopt;
  const std::string value = code.substr(at + 3);
  if (value.starts_with('{') || value.find(';') + 1 != value.size()) return std::nullopt;
  return Parts{code.substr(0, at + 3), value.substr(0, value.size() - 1), ";"};
}

/// `if (value) {`
std::optional<Parts> as_condition(const std::string& code) {
  const std::string head = "if (";
  const std::string tail = ") {";
  if (!code.starts_with(head) || !code.ends_with(tail)) return std::nullopt;
  return Parts{head, code.substr(head.size(), code.size() - head.size() - tail.size()), tail};
}

bool is_statement(const std::string& code) {
  return is_balanced(code) && code.ends_with(';') && !is_declaration(code);
}

/// Statements that stand in a block of their own, and may declare what they need.
bool is_block(const std::string& code) {
  return code.empty() || (is_balanced(code) && (code.ends_with(';') || code.ends_with('}')));
}

std::optional<Form> form_of(const std::string& old_code, const std::string& new_code) {
  if (old_code.find("constexpr") != std::string::npos) return std::nullopt;
  const auto fits = [&](const auto& parts_of) {
    const auto of_old = parts_of(old_code);
    const auto of_new = parts_of(new_code);
    return of_old && of_new && of_old->head == of_new->head && is_balanced(of_new->value) &&
           is_balanced(of_old->value);
  };
  if (fits(as_variable)) return Form::variable;
  if (fits(as_condition)) return Form::condition;
  if (is_statement(old_code) && is_block(new_code)) return Form::statement;
  return std::nullopt;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

bool is_line_of(const Edit& edit, const std::string& line) {
  return !edit.old_line.empty() && line.ends_with(edit.old_line) &&
         line.find_first_not_of(' ') == line.size() - edit.old_line.size();
}

/// Whether the line after this code begins a new statement.
bool is_complete(const std::string& code) {
  constexpr std::string_view kEnds = ";{}:";
  return code.empty() || code.starts_with("//") || kEnds.find(code.back()) != kEnds.npos;
}

std::string switch_of(const Edit& edit) {
  return "canary::is_acting(" + std::to_string(edit.line) + ")";
}

/// The line, behind one switch for each of the edits.
std::string switched_line(const std::string& line, std::span<const Edit> edits) {
  const std::string old_code = stripped(line);
  std::string before;
  std::string after = stripped(line);
  for (const Edit& edit : edits) {
    const std::string new_code = stripped(edit.new_lines);
    const Form form = form_of(old_code, new_code).value();
    if (form == Form::statement) {
      before += "if (" + switch_of(edit) + ") {\n" + edit.new_lines + "} else ";
      after = "{ " + old_code + " }";
      continue;
    }
    const auto parts_of = form == Form::variable ? as_variable : as_condition;
    const Parts parts = parts_of(old_code).value();
    if (before.empty()) before = parts.head;
    before += switch_of(edit) + " ? (" + parts_of(new_code)->value + ") : ";
    after = "(" + parts.value + ")" + parts.tail;
  }
  return before + after + "\n";
}

}  // namespace

bool fits_switch(const Edit& edit, const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  const auto line =
      std::ranges::find_if(lines, [&](const auto& at) { return is_line_of(edit, at); });
  if (line == lines.end()) return false;
  const std::string before = line == lines.begin() ? "" : stripped(*(line - 1));
  const std::string after = line + 1 == lines.end() ? "" : stripped(*(line + 1));
  return is_complete(before) && !after.starts_with("else") &&
         form_of(stripped(*line), stripped(edit.new_lines)).has_value();
}

std::string switched(std::span<const Edit> edits, const std::string& text) {
  std::string result;
  for (const std::string& line : lines_of(text)) {
    std::vector<Edit> of_line;
    std::ranges::copy_if(edits, std::back_inserter(of_line),
                         [&](const Edit& edit) { return is_line_of(edit, line); });
    result += of_line.empty() ? line + "\n" : switched_line(line, of_line);
  }
  return result;
}

}  // namespace manifuzz::canary
