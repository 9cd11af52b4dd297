#include "unit/functions.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace manifuzz::test {
namespace {

using Tokens = std::vector<std::string>;

bool is_in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_word(std::string_view token) {
  return !token.empty() && is_in_word(token.front()) &&
         std::isdigit(static_cast<unsigned char>(token.front())) == 0;
}

/// How long the comment, string, character or line of the preprocessor is that `text` begins with;
/// 0 where it begins with none.
std::size_t length_of_skipped(std::string_view text) {
  const auto up_to = [text](std::string_view end, std::size_t from) {
    const std::size_t found = text.find(end, from);
    return found == text.npos ? text.size() : found + end.size();
  };
  if (text.starts_with("//")) return up_to("\n", 0);
  if (text.starts_with("/*")) return up_to("*/", 2);
  if (text.starts_with("R\"")) {
    const std::size_t open = text.find('(');
    return up_to(")" + std::string(text.substr(2, open - 2)) + "\"", open);
  }
  if (text.front() == '"' || text.front() == '\'') {
    std::size_t end = 1;
    while (end < text.size() && text[end] != text.front()) end += text[end] == '\\' ? 2 : 1;
    return end + 1;
  }
  if (text.front() != '#') return 0;
  std::size_t end = up_to("\n", 0);
  while (end >= 2 && end < text.size() && text[end - 2] == '\\') end = up_to("\n", end);
  return end;
}

/// Words, and signs one by one but for "::"; a literal is the word "0".
Tokens tokens_of(std::string_view text) {
  Tokens tokens;
  while (!text.empty()) {
    std::size_t length = length_of_skipped(text);
    const bool is_literal = length > 0 && (text.front() == '"' || text.front() == '\'');
    if (length == 0 && is_in_word(text.front())) {
      const bool is_number = !is_word(text.substr(0, 1));
      while (length < text.size() &&
             (is_in_word(text[length]) ||
              (is_number && (text[length] == '\'' || text[length] == '.')))) {
        ++length;
      }
      tokens.emplace_back(is_number ? "0" : text.substr(0, length));
    } else if (is_literal) {
      tokens.emplace_back("0");
    } else if (length == 0) {
      length = text.starts_with("::") ? 2 : 1;
      if (std::isspace(static_cast<unsigned char>(text.front())) == 0) {
        tokens.emplace_back(text.substr(0, length));
      }
    }
    text.remove_prefix(std::min(length, text.size()));
  }
  return tokens;
}

/// By how much a token changes the depth of brackets.
int nesting(std::string_view token) {
  if (token == "(" || token == "{" || token == "[" || token == "<") return 1;
  if (token == ")" || token == "}" || token == "]" || token == ">") return -1;
  return 0;
}

/// The place behind the bracket that closes the one at `open`, of those alone.
std::size_t behind_closing(const Tokens& tokens, std::size_t open) {
  const std::string& opening = tokens[open];
  const std::string closing = opening == "(" ? ")" : opening == "{" ? "}" : "]";
  int depth = 0;
  for (std::size_t at = open; at < tokens.size(); ++at) {
    if (tokens[at] == opening) ++depth;
    if (tokens[at] == closing && --depth == 0) return at + 1;
  }
  return tokens.size();
}

/// The type of a parameter, without its name and its default.
std::string type_of(Tokens parameter) {
  parameter.erase(std::ranges::find(parameter, "="), parameter.end());
  if (parameter == Tokens{"void"}) parameter.clear();
  const std::size_t count = parameter.size();
  const bool is_named = count >= 2 && is_word(parameter.back()) && parameter[count - 2] != "::" &&
                        parameter[count - 2] != "const";
  if (is_named) parameter.pop_back();
  return fmt::format("{}", fmt::join(parameter, " "));
}

/// The types of the parameters within the parenthesis at `open`.
std::string types_of(const Tokens& statement, std::size_t open) {
  std::vector<std::string> types;
  Tokens parameter;
  int depth = 0;
  for (std::size_t at = open + 1; at + 1 < behind_closing(statement, open); ++at) {
    depth += nesting(statement[at]);
    if (depth == 0 && statement[at] == ",") {
      types.push_back(type_of(parameter));
      parameter.clear();
    } else {
      parameter.push_back(statement[at]);
    }
  }
  types.push_back(type_of(parameter));
  return fmt::format("{}", fmt::join(types, ", "));
}

/// Where a statement first has one of these tokens outside of all parentheses; its size where it
/// does not.
std::size_t find_outside(const Tokens& statement, std::initializer_list<std::string_view> sought) {
  std::size_t at = 0;
  while (at < statement.size() && std::ranges::find(sought, statement[at]) == sought.end()) {
    at = statement[at] == "(" ? behind_closing(statement, at) : at + 1;
  }
  return std::min(at, statement.size());
}

/// Whether the parenthesis at `open` holds parameters, by what stands before it.
bool opens_parameters(const Tokens& statement, std::size_t open) {
  if (open < 2 || !is_word(statement[open - 1]) || statement[open - 1] == "requires") return false;
  const std::string& before = statement[open - 2];
  return is_word(before) || before == ">" || before == "]" || before == "*" || before == "&";
}

/// The parenthesis that opens the parameters of the function that a statement is about; its size
/// where it is about none.
std::size_t find_parameters(const Tokens& statement) {
  const std::size_t end = find_outside(statement, {"=", "operator"});
  int depth = 0;
  for (std::size_t at = 0; at < end; ++at) {
    if (statement[at] == "(") {
      if (depth == 0 && opens_parameters(statement, at)) return at;
      at = behind_closing(statement, at) - 1;
    }
    if (statement[at] == "<") ++depth;
    if (statement[at] == ">") --depth;
  }
  return statement.size();
}

/// Whether a statement that stands before a brace, or a semicolon, begins with one of these words.
bool begins_with(const Tokens& statement, std::initializer_list<std::string_view> words) {
  return !statement.empty() && std::ranges::find(words, statement.front()) != words.end();
}

/// Whether the braces that follow end the statement, being a function's, and no class's or
/// variable's.
bool is_over_at_brace(const Tokens& statement) {
  const auto has = [&](std::string_view token) {
    return std::ranges::find(statement, token) != statement.end();
  };
  const bool is_set = find_outside(statement, {"="}) < statement.size();
  return !begins_with(statement, {"struct", "class", "enum", "union"}) && has("(") &&
         (has("operator") || !is_set);
}

/// Reads a text from namespace to namespace.
class Reading {
 public:
  std::vector<NamedFunction> functions_of(const Tokens& tokens) {
    for (std::size_t at = 0; at < tokens.size();) at = read(tokens, at);
    return functions_;
  }

 private:
  /// Takes what stands at a place of the text, outside of all functions and classes; the place
  /// behind it.
  std::size_t read(const Tokens& tokens, std::size_t at) {
    const std::string& token = tokens[at];
    if (token == "(") {
      const std::size_t end = behind_closing(tokens, at);
      statement_.insert(statement_.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at),
                        tokens.begin() + static_cast<std::ptrdiff_t>(end));
      return end;
    }
    if (token == "{" && begins_with(statement_, {"namespace", "inline", "extern"}) && enter()) {
      return at + 1;
    }
    if (token == "{") {
      take(true);
      if (is_over_at_brace(statement_)) statement_.clear();
      return behind_closing(tokens, at);
    }
    if (token == "}" && !scopes_.empty()) scopes_.pop_back();
    if (token == ";") take(false);
    if (token == ";" || token == "}") {
      statement_.clear();
    } else {
      statement_.push_back(token);
    }
    return at + 1;
  }

  /// Enters the namespace that a statement opens, if it opens one.
  bool enter() {
    const auto word = std::ranges::find(statement_, "namespace");
    if (word == statement_.end()) return false;
    std::string name;
    for (auto at = word + 1; at != statement_.end(); ++at) name += *at;
    scopes_.push_back(name);
    statement_.clear();
    return true;
  }

  /// Keeps the function that the statement is about, if it is about one.
  void take(bool has_body) {
    if (begins_with(statement_, {"using", "typedef", "struct", "class", "enum", "union", "friend",
                                 "static_assert"})) {
      return;
    }
    const std::size_t open = find_parameters(statement_);
    if (open == statement_.size()) return;
    NamedFunction function{.scope = {},
                           .name = statement_[open - 1],
                           .parameters = types_of(statement_, open),
                           .has_body = has_body};
    for (const std::string& scope : scopes_) {
      if (scope.empty()) function.is_hidden = true;
      if (!scope.empty()) function.scope += (function.scope.empty() ? "" : "::") + scope;
    }
    functions_.push_back(function);
  }

  std::vector<std::string> scopes_;
  Tokens statement_;
  std::vector<NamedFunction> functions_;
};

}  // namespace

std::vector<NamedFunction> functions_in(std::string_view text) {
  return Reading().functions_of(tokens_of(text));
}

}  // namespace manifuzz::test
