#include "cases/json_tree.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/text.hpp"
#include "cases/user_error.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kDeepest = 32;

/// How a path goes on to a member of that name.
std::string step_to(std::string_view key) {
  const bool plain = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_';
  });
  return plain ? fmt::format(".{}", printable(key)) : fmt::format("[\"{}\"]", printable(key));
}

/// How a path goes on from `from` to the value at the address `target`. Found by search, so that
/// only errors pay for paths.
std::optional<std::string> steps_to(const Json& from, const Json* target) {
  if (&from == target) return "";
  if (from.is_array()) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const auto rest = steps_to(from[i], target);
      if (rest) return fmt::format("[{}]{}", i, *rest);
    }
  } else if (from.is_object()) {
    for (const auto& [key, member] : from.get_ref<const Json::object_t&>()) {
      const auto rest = steps_to(member, target);
      if (rest) return step_to(key) + *rest;
    }
  }
  return std::nullopt;
}

std::string path_of(const Json& root, const Json& value) {
  return fmt::format("${}", steps_to(root, &value).value_or(""));
}

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
class TreeBuilder : public nlohmann::json_sax<Json> {
 public:
  explicit TreeBuilder(std::string_view text) : text_(text) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override {
    // Only tokens with a minus sign come here, so zero is "-0".
    return value == 0 ? add(-0.0) : add(value);
  }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    const auto [place, is_new] = open_.back()->get_ref<Json::object_t&>().emplace(key, nullptr);
    if (!is_new) {
      error_ = fmt::format("{}: the key \"{}\" is repeated; give it once",
                           path_of(root, *open_.back()), printable(key));
    }
    member_ = &place->second;
    key_ = key;
    return is_new;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) {
      error_ = fmt::format("{}: {} is beyond the largest number; magnitudes must be below 3.4e38",
                           next_path(), printable(token));
    } else {
      error_ = fmt::format("{}: {}", place_of(text_, position),
                           syntax_error(word_at(text_, position), error.what()));
    }
    return false;
  }

  Json root;
  const std::string& error() const { return error_; }

 private:
  Json* place(Json&& value) {
    Json* at = &root;
    if (!open_.empty()) {
      Json& parent = *open_.back();
      if (parent.is_array()) {
        parent.get_ref<Json::array_t&>().push_back(std::move(value));
        return &parent.back();
      }
      at = member_;
    }
    *at = std::move(value);
    return at;
  }

  bool add(Json value) {
    place(std::move(value));
    return true;
  }

  bool open(Json container) {
    if (open_.size() == kDeepest) {
      error_ = fmt::format("$: nested deeper than {} levels; a case needs 5", kDeepest);
      return false;
    }
    open_.push_back(place(std::move(container)));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  /// Where the value that is being read will stand.
  std::string next_path() const {
    if (open_.empty()) return "$";
    const Json& parent = *open_.back();
    const std::string path = path_of(root, parent);
    return path + (parent.is_array() ? fmt::format("[{}]", parent.size()) : step_to(key_));
  }

  std::string_view text_;
  std::vector<Json*> open_;  // from the root down; only the last one grows, so they stay in place
  Json* member_ = nullptr;
  std::string key_;
  std::string error_;
};

}  // namespace

Json parse_json(std::string_view text) {
  // The parser takes a NUL for the end and would not see what follows it.
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) {
    throw UserError(
        fmt::format("{}: not JSON: a NUL byte; UTF-8 text is expected", place_of(text, nul + 1)));
  }
  TreeBuilder builder(text);
  if (!Json::sax_parse(text.data(), text.data() + text.size(), &builder)) {
    throw UserError(builder.error());
  }
  return std::move(builder.root);
}

void JsonView::expect_keys(std::initializer_list<std::string_view> allowed) const {
  for (const auto& [key, member] : members()) {
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end()) {
      fail(fmt::format("unknown key \"{}\"; the keys are {}", printable(key),
                       fmt::join(allowed, ", ")));
    }
  }
}

std::optional<JsonView> JsonView::find(std::string_view key) const {
  const auto& object = members();
  const auto member = object.find(key);
  if (member == object.end()) return std::nullopt;
  return JsonView(*root_, member->second);
}

JsonView JsonView::at(std::string_view key) const {
  const auto member = find(key);
  if (!member) fail(fmt::format("the key \"{}\" is missing; it is required", key));
  return *member;
}

std::size_t JsonView::length(std::string_view expected) const {
  if (!value_->is_array()) fail_type(expected);
  return value_->size();
}

double JsonView::number() const {
  if (!value_->is_number()) fail_type("a number");
  return value_->get<double>();
}

float JsonView::number_as_float() const {
  const double value = number();
  const auto rounded = static_cast<float>(value);
  if (!std::isfinite(rounded)) {
    fail(fmt::format("{} is beyond the largest float; magnitudes must be below 3.4e38", value));
  }
  return rounded;
}

std::uint64_t JsonView::whole_number() const {
  constexpr std::string_view expected = "a whole number from 0 to 18446744073709551615";
  if (!value_->is_number()) fail_type(expected);
  if (!value_->is_number_unsigned()) {
    fail(fmt::format("{} is out of range; {} is expected", value_->dump(), expected));
  }
  return value_->get<std::uint64_t>();
}

const std::string& JsonView::string() const {
  if (!value_->is_string()) fail_type("a string");
  return value_->get_ref<const std::string&>();
}

const Json::object_t& JsonView::members() const {
  if (!value_->is_object()) fail_type("an object");
  return value_->get_ref<const Json::object_t&>();
}

void JsonView::fail(std::string_view what) const {
  throw UserError(fmt::format("{}: {}", path_of(*root_, *value_), what));
}

void JsonView::fail_type(std::string_view expected) const {
  const std::string_view type = value_->type_name();
  const bool vowel = type == "array" || type == "object";
  fail(fmt::format("is {}{}; {} is expected",
                   type == "null" ? ""
                   : vowel        ? "an "
                                  : "a ",
                   type, expected));
}

}  // namespace manifuzz
