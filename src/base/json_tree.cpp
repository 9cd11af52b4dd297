#include "base/json_tree.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/names.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"

namespace manifuzz {

std::string path_step(std::string_view key) {
  const bool plain = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_';
  });
  return plain ? fmt::format(".{}", printable(key)) : fmt::format("[\"{}\"]", printable(key));
}

std::optional<std::size_t> JsonTree::find(std::size_t object, std::string_view key) const {
  std::size_t member = object + 1;
  for (std::size_t i = 0; i < nodes[object].children; ++i) {
    if (view(nodes[member].key) == key) return member;
    member += nodes[member].extent;
  }
  return std::nullopt;
}

std::string JsonTree::path_of(std::size_t target) const {
  std::string path = "$";
  std::size_t above = 0;
  while (above != target) {
    std::size_t child = above + 1;
    std::size_t place = 0;
    while (nodes[child].extent <= target - child) {
      child += nodes[child].extent;
      ++place;
    }
    const bool is_element = nodes[above].type == JsonType::array;
    path += is_element ? fmt::format("[{}]", place) : path_step(view(nodes[child].key));
    above = child;
  }
  return path;
}

void JsonView::expect_keys(std::initializer_list<std::string_view> allowed) const {
  expect_type(JsonType::object, "an object");
  std::size_t member = index_ + 1;
  for (std::size_t i = 0; i < node().children; ++i) {
    const std::string_view key = tree_->view(tree_->nodes[member].key);
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end()) {
      const auto meant = nearest(key, {allowed.begin(), allowed.end()});
      fail(fmt::format("unknown key \"{}\"; {} keys are {}", printable(key),
                       meant ? fmt::format("did you mean \"{}\"? The", *meant) : "the",
                       fmt::join(allowed, ", ")));
    }
    member += tree_->nodes[member].extent;
  }
}

std::vector<std::string_view> JsonView::keys() const {
  expect_type(JsonType::object, "an object");
  std::vector<std::string_view> keys;
  std::size_t member = index_ + 1;
  for (std::size_t i = 0; i < node().children; ++i) {
    keys.push_back(tree_->view(tree_->nodes[member].key));
    member += tree_->nodes[member].extent;
  }
  return keys;
}

std::optional<JsonView> JsonView::find(std::string_view key) const {
  expect_type(JsonType::object, "an object");
  const auto member = tree_->find(index_, key);
  if (!member) return std::nullopt;
  return JsonView(*tree_, *member);
}

JsonView JsonView::at(std::string_view key) const {
  const auto member = find(key);
  if (!member) fail(fmt::format("the key \"{}\" is missing; it is required", key));
  return *member;
}

std::size_t JsonView::length(std::string_view expected) const {
  expect_type(JsonType::array, expected);
  return node().children;
}

std::vector<JsonView> JsonView::elements(std::string_view expected) const {
  std::vector<JsonView> all;
  std::size_t element = index_ + 1;
  for (std::size_t i = 0; i < length(expected); ++i) {
    all.push_back(JsonView(*tree_, element));
    element += tree_->nodes[element].extent;
  }
  return all;
}

JsonView JsonView::operator[](std::size_t i) const {
  std::size_t element = index_ + 1;
  for (; i > 0; --i) element += tree_->nodes[element].extent;
  return {*tree_, element};
}

bool JsonView::boolean() const {
  expect_type(JsonType::boolean, "true or false");
  return node().is_true;
}

double JsonView::number() const {
  expect_type(JsonType::number, "a number");
  return node().number;
}

double JsonView::magnitude() const {
  if (is_null()) return std::numeric_limits<double>::infinity();
  const double value = number();
  if (value >= 0) return value;
  fail(fmt::format("{} is no magnitude; a number from 0 is expected", value));
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
  expect_type(JsonType::number, expected);
  if (!node().is_whole) fail(fmt::format("{} is not written as {}", node().number, expected));
  return node().whole;
}

std::string_view JsonView::string() const {
  expect_type(JsonType::string, "a string");
  return tree_->view(node().string);
}

void JsonView::fail(std::string_view what) const {
  throw UserError(fmt::format("{}: {}", tree_->path_of(index_), what));
}

void JsonView::expect_type(JsonType type, std::string_view expected) const {
  constexpr std::array<std::string_view, 6> names = {"null",     "a boolean", "a number",
                                                     "a string", "an array",  "an object"};
  if (node().type == type) return;
  fail(
      fmt::format("is {}; {} is expected", names[static_cast<std::size_t>(node().type)], expected));
}

}  // namespace manifuzz
