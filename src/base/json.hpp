#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace manifuzz {

/// A parsed text.
struct JsonTree {
  std::shared_ptr<const nlohmann::ordered_json> root;
};

/// The one JSON value that `text` holds, between any white space. Stricter than JSON where JSON is
/// vague: a repeated key, more than 64 keys, a number beyond double, nesting deeper than 32 levels
/// and a NUL byte are errors. Throws UserError that begins with a line and column, or with a path.
JsonTree parse_json(std::string_view text);

/// A value inside a parsed tree, read with checks. Whatever is wrong is a UserError that begins
/// with the value's path, such as $.a.vertices[2][0]. The tree must outlive the view.
class JsonView {
 public:
  explicit JsonView(const JsonTree& tree) : JsonView(*tree.root, *tree.root) {}

  bool is_null() const;
  bool is_object() const;
  bool is_string() const;

  /// Fails unless this is an object whose keys are all among `allowed`.
  void expect_keys(std::span<const std::string_view> allowed) const;
  void expect_keys(std::initializer_list<std::string_view> allowed) const {
    expect_keys(std::span(allowed.begin(), allowed.size()));
  }
  /// The names of an object's members.
  std::vector<std::string_view> keys() const;
  /// The member of that name; this must be an object.
  std::optional<JsonView> find(std::string_view key) const;
  JsonView at(std::string_view key) const;

  /// The length of an array; anything else fails with `expected` ("an array of two numbers").
  std::size_t length(std::string_view expected = "an array") const;
  /// The elements of an array.
  std::vector<JsonView> elements(std::string_view expected = "an array") const;
  /// Element i of an array, i below its length.
  JsonView operator[](std::size_t i) const;

  bool boolean() const;
  double number() const;
  /// 0 or more; null stands for infinity, which JSON has not.
  double magnitude() const;
  /// The nearest double, then the nearest float; beyond the largest float is an error.
  float number_as_float() const;
  std::uint64_t whole_number() const;
  std::string_view string() const;
  /// The string of that name, where this object has it.
  std::string string_or(std::string_view key, std::string_view otherwise) const;

  [[noreturn]] void fail(std::string_view what) const;

 private:
  using Json = nlohmann::ordered_json;
  JsonView(const Json& root, const Json& value) : root_(&root), value_(&value) {}
  JsonView with(const Json& value) const { return {*root_, value}; }
  /// Fails unless `is_it`.
  void expect(bool is_it, std::string_view expected) const;

  const Json* root_;
  const Json* value_;
};

}  // namespace manifuzz
