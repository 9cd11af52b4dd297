#include "base/json.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

std::string type_of(const Json& value) {
  const std::string article = value.is_structured() ? "an " : "a ";
  return (value.is_null() ? "" : article) + value.type_name();
}

/// How a path goes on to a member of that name.
std::string path_step(std::string_view key) {
  const bool plain = !key.empty() && std::ranges::all_of(key, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_';
  });
  return plain ? fmt::format(".{}", printable(key)) : fmt::format("[\"{}\"]", printable(key));
}

/// Makes `path`, which leads to `at`, lead to `target`, where that is `at` or below.
bool extend_path(std::string& path, const Json& at, const Json& target) {
  if (&at == &target) return true;
  if (!at.is_structured()) return false;  // others count themselves among their items
  const std::size_t length = path.size();
  for (const auto& [key, value] : at.items()) {
    path += at.is_array() ? fmt::format("[{}]", key) : path_step(key);
    if (extend_path(path, value, target)) return true;
    path.resize(length);
  }
  return false;
}

/// "$.a.vertices[2]" for a value in the tree.
std::string path_of(const Json& root, const Json& target) {
  std::string path = "$";
  extend_path(path, root, target);
  return path;
}

constexpr std::size_t kDeepest = 32;
constexpr std::size_t kMostKeys = 64;

/// "line 3, column 17" of the byte at `position`, counted from 1; "column 17" of a single line.
std::string place_of(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position > 0 ? position - 1 : 0);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
  if (text.find('\n') == std::string_view::npos) return fmt::format("column {}", column);
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
class TreeBuilder final : public nlohmann::json_sax<Json> {
 public:
  explicit TreeBuilder(std::string_view text) : text_(text) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override {
    // Only tokens with a minus sign come here, so zero is "-0".
    return add(value == 0 ? -0.0 : static_cast<double>(value));
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
    const Json& object = *open_.back();
    if (object.contains(key)) {
      error_ = fmt::format("{}: the key \"{}\" is repeated; give it once", path_of(root, object),
                           printable(key));
    } else if (object.size() == kMostKeys) {
      error_ = fmt::format("{}: has more than {} keys", path_of(root, object), kMostKeys);
    }
    key_ = std::move(key);
    return error_.empty();
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) {
      add(nullptr);
      error_ = fmt::format("{}: {} is beyond the largest number, 1.8e308", path_of(root, *last_),
                           printable(token));
    } else {
      error_ = fmt::format("{}: {}", place_of(text_, position),
                           syntax_error(word_at(text_, position), error.what()));
    }
    return false;
  }

  Json root;
  const std::string& error() const { return error_; }

 private:
  bool add(Json value) {
    if (open_.empty()) {
      root = std::move(value);
      last_ = &root;
    } else if (Json& parent = *open_.back(); parent.is_array()) {
      last_ = &parent.emplace_back(std::move(value));
    } else {
      last_ = &(parent[key_] = std::move(value));
    }
    return true;
  }

  bool open(Json container) {
    if (open_.size() == kDeepest) {
      error_ = fmt::format("$: nested deeper than {} levels", kDeepest);
      return false;
    }
    if (container.is_array()) container.get_ref<Json::array_t&>().reserve(2);  // mostly points
    add(std::move(container));
    open_.push_back(last_);
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  std::vector<Json*> open_;  // from the root down
  Json* last_ = nullptr;     // what was added last
  std::string key_;          // of the member to come
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
  if (!Json::sax_parse(text.data(), text.data() + text.size(), &builder)) {
    throw UserError(builder.error());
  }
  return {std::make_shared<const Json>(std::move(builder.root))};
}

bool JsonView::is_null() const {
  return value_->is_null();
}

bool JsonView::is_object() const {
  return value_->is_object();
}

bool JsonView::is_string() const {
  return value_->is_string();
}

void JsonView::expect_keys(std::span<const std::string_view> allowed) const {
  for (const std::string_view key : keys()) {
    if (std::ranges::find(allowed, key) != allowed.end()) continue;
    const auto meant = nearest(key, {allowed.begin(), allowed.end()});
    fail(fmt::format("unknown key \"{}\"; {} keys are {}", printable(key),
                     meant ? fmt::format("did you mean \"{}\"? The", *meant) : "the",
                     fmt::join(allowed, ", ")));
  }
}

std::vector<std::string_view> JsonView::keys() const {
  expect(is_object(), "an object");
  std::vector<std::string_view> keys;
  for (const auto& [key, value] : value_->get_ref<const Json::object_t&>()) keys.push_back(key);
  return keys;
}

std::optional<JsonView> JsonView::find(std::string_view key) const {
  expect(is_object(), "an object");
  const auto member = value_->find(key);
  if (member == value_->end()) return std::nullopt;
  return with(*member);
}

JsonView JsonView::at(std::string_view key) const {
  const auto member = find(key);
  if (!member) fail(fmt::format("the key \"{}\" is missing; it is required", key));
  return *member;
}

std::size_t JsonView::length(std::string_view expected) const {
  expect(value_->is_array(), expected);
  return value_->size();
}

std::vector<JsonView> JsonView::elements(std::string_view expected) const {
  std::vector<JsonView> all;
  for (std::size_t i = 0; i < length(expected); ++i) all.push_back((*this)[i]);
  return all;
}

JsonView JsonView::operator[](std::size_t i) const {
  return with((*value_)[i]);
}

bool JsonView::boolean() const {
  expect(value_->is_boolean(), "true or false");
  return value_->get<bool>();
}

double JsonView::number() const {
  expect(value_->is_number(), "a number");
  return value_->get<double>();
}

double JsonView::magnitude() const {
  if (is_null()) return std::numeric_limits<double>::infinity();
  const double value = number();
  if (value >= 0) return value;
  fail(fmt::format("{} is no magnitude; a number from 0 is expected", value));
}

float JsonView::number_as_float() const {
  const auto rounded = static_cast<float>(number());
  if (!std::isfinite(rounded)) {
    fail(fmt::format("{} is beyond the largest float; magnitudes must be below 3.4e38", number()));
  }
  return rounded;
}

std::uint64_t JsonView::whole_number() const {
  constexpr std::string_view expected = "a whole number from 0 to 18446744073709551615";
  expect(value_->is_number(), expected);
  if (!value_->is_number_unsigned()) {
    fail(fmt::format("{} is not written as {}", number(), expected));
  }
  return value_->get<std::uint64_t>();
}

std::string_view JsonView::string() const {
  expect(value_->is_string(), "a string");
  return value_->get_ref<const std::string&>();
}

std::string JsonView::string_or(std::string_view key, std::string_view otherwise) const {
  const auto member = find(key);
  return std::string(member ? member->string() : otherwise);
}

void JsonView::fail(std::string_view what) const {
  throw UserError(fmt::format("{}: {}", path_of(*root_, *value_), what));
}

void JsonView::expect(bool is_it, std::string_view expected) const {
  if (!is_it) fail(fmt::format("is {}; {} is expected", type_of(*value_), expected));
}

}  // namespace manifuzz
