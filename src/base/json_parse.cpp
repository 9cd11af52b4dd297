#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/json_tree.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"

namespace manifuzz {
namespace {

using Parser = nlohmann::json;

constexpr std::size_t kDeepest = 32;
constexpr std::size_t kMostKeys = 64;

/// "line 3, column 17" of the byte at `position`, counted from 1; "column 17" of a single line.
std::string place_of(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position > 0 ? position - 1 : 0);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t last_end = before.rfind('\n');
  const std::size_t start = last_end == std::string_view::npos ? 0 : last_end + 1;
  const std::size_t column = before.size() - start + 1;
  if (line == 1 && text.find('\n') == std::string_view::npos)
    return fmt::format("column {}", column);
  return fmt::format("line {}, column {}", line, column);
}

/// The word around the byte at `position`, counted from 1.
std::string_view word_at(std::string_view text, std::size_t position) {
  constexpr std::string_view delimiters = " \t\r\n,:[]{}\"";
  const std::string_view before = text.substr(0, position > 0 ? position - 1 : 0);
  const std::size_t start = before.find_last_of(delimiters) + 1;  // npos + 1 is 0
  return text.substr(start, text.find_first_of(delimiters, start) - start);
}

bool is_no_number(std::string_view word) {
  const bool has_sign = word.starts_with('-') || word.starts_with('+');
  const std::string_view name = word.substr(has_sign ? 1 : 0);
  return name == "NaN" || name == "nan" || name.starts_with("Inf") || name.starts_with("inf");
}

/// What the parser says, without its own prefix and without the raw bytes it read last.
std::string syntax_error(std::string_view word, std::string_view what) {
  if (is_no_number(word)) return "not JSON: numbers must be finite, NaN and Infinity are not";
  const std::size_t dash = what.find(" - ");
  const std::string_view reason = dash == std::string_view::npos ? what : what.substr(dash + 3);
  const std::size_t raw = reason.find("; last read: ");
  if (raw == std::string_view::npos) return fmt::format("not JSON: {}", printable(reason, 200));
  return fmt::format("not JSON: {} at '{}'; UTF-8 text with one JSON object is expected",
                     printable(reason.substr(0, raw), 200), printable(word, 20));
}

/// Builds the tree from the parser's events, and stops at what JSON would let pass.
class TreeBuilder final : public nlohmann::json_sax<Parser> {
 public:
  explicit TreeBuilder(std::string_view text) : text_(text) {}

  bool null() override { return add({}); }
  bool boolean(bool value) override { return add({.type = JsonType::boolean, .is_true = value}); }
  bool number_integer(number_integer_t value) override {
    // Only tokens with a minus sign come here, so zero is "-0".
    const double number = value == 0 ? -0.0 : static_cast<double>(value);
    return add({.type = JsonType::number, .number = number});
  }
  bool number_unsigned(number_unsigned_t value) override {
    return add({.type = JsonType::number,
                .is_whole = true,
                .number = static_cast<double>(value),
                .whole = value});
  }
  bool number_float(number_float_t value, const string_t&) override {
    return add({.type = JsonType::number, .number = value});
  }
  bool string(string_t& value) override {
    return add({.type = JsonType::string, .string = keep(value)});
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonType::object); }
  bool start_array(std::size_t) override { return open(JsonType::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    const std::size_t object = open_.back();
    if (tree.find(object, key)) {
      error_ = fmt::format("{}: the key \"{}\" is repeated; give it once", tree.path_of(object),
                           printable(key));
    } else if (tree.nodes[object].children == kMostKeys) {
      error_ = fmt::format("{}: has more than {} keys", tree.path_of(object), kMostKeys);
    }
    key_ = keep(key);
    return error_.empty();
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) {
      error_ = fmt::format("{}: {} is beyond the largest number, 1.8e308", next_path(),
                           printable(token));
    } else {
      error_ = fmt::format("{}: {}", place_of(text_, position),
                           syntax_error(word_at(text_, position), error.what()));
    }
    return false;
  }

  JsonTree tree;
  const std::string& error() const { return error_; }

 private:
  TextPiece keep(std::string_view text) {
    tree.text += text;
    return {tree.text.size() - text.size(), text.size()};
  }

  bool add(JsonNode node) {
    if (!open_.empty()) {
      JsonNode& parent = tree.nodes[open_.back()];
      if (parent.type == JsonType::object) node.key = key_;
      ++parent.children;
    }
    tree.nodes.push_back(node);
    return true;
  }

  bool open(JsonType type) {
    if (open_.size() == kDeepest) {
      error_ = fmt::format("$: nested deeper than {} levels", kDeepest);
      return false;
    }
    add({.type = type, .extent = JsonTree::kStillOpen});
    open_.push_back(tree.nodes.size() - 1);
    return true;
  }

  bool close() {
    const std::size_t container = open_.back();
    tree.nodes[container].extent = tree.nodes.size() - container;
    open_.pop_back();
    return true;
  }

  /// Where the value that is being read will stand.
  std::string next_path() const {
    if (open_.empty()) return "$";
    const JsonNode& parent = tree.nodes[open_.back()];
    return tree.path_of(open_.back()) + (parent.type == JsonType::array
                                             ? fmt::format("[{}]", parent.children)
                                             : path_step(tree.view(key_)));
  }

  std::string_view text_;
  std::vector<std::size_t> open_;  // from the root down
  TextPiece key_;                  // of the member to come
  std::string error_;
};

}  // namespace

JsonTree parse_json(std::string_view text) {
  // The parser takes a NUL for the end and would not see what follows it.
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) {
    throw UserError(
        fmt::format("{}: not JSON: a NUL byte; UTF-8 text is expected", place_of(text, nul + 1)));
  }
  TreeBuilder builder(text);
  if (!Parser::sax_parse(text.data(), text.data() + text.size(), &builder)) {
    throw UserError(builder.error());
  }
  return std::move(builder.tree);
}

}  // namespace manifuzz
