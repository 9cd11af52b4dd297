#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace manifuzz {

using Json = nlohmann::json;

/// The one JSON value that `text` holds, between any white space. Stricter than JSON where JSON is
/// vague: a repeated key, a number beyond double, nesting deeper than 32 levels and a NUL byte are
/// errors. Throws UserError that begins with a line and column, or with a path such as $.a.radius.
Json parse_json(std::string_view text);

/// A value inside a parsed tree, read with checks. Whatever is wrong is a UserError that begins
/// with the value's path, such as $.a.vertices[2][0]. The tree must outlive the view.
class JsonView {
 public:
  explicit JsonView(const Json& root) : JsonView(root, root) {}

  /// Fails unless this is an object whose keys are all among `allowed`.
  void expect_keys(std::initializer_list<std::string_view> allowed) const;
  bool is_null() const { return value_->is_null(); }

  /// The member of that name; this must be an object.
  std::optional<JsonView> find(std::string_view key) const;
  JsonView at(std::string_view key) const;

  /// The length of an array; anything else fails with `expected` ("an array of two numbers").
  std::size_t length(std::string_view expected = "an array") const;
  JsonView operator[](std::size_t i) const { return {*root_, (*value_)[i]}; }

  double number() const;
  /// The nearest double, then the nearest float; beyond the largest float is an error.
  float number_as_float() const;
  std::uint64_t whole_number() const;
  const std::string& string() const;
  /// The members of an object, by name.
  const Json::object_t& members() const;

  [[noreturn]] void fail(std::string_view what) const;

 private:
  JsonView(const Json& root, const Json& value) : root_(&root), value_(&value) {}
  [[noreturn]] void fail_type(std::string_view expected) const;

  const Json* root_;
  const Json* value_;
};

}  // namespace manifuzz
