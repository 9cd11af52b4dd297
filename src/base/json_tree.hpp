#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace manifuzz {

enum class JsonType : unsigned char { null, boolean, number, string, array, object };

/// A piece of a tree's text.
struct TextPiece {
  std::size_t start = 0;
  std::size_t length = 0;
};

/// A value of a tree. The elements or members of a container follow it, each with all that is
/// below.
struct JsonNode {
  JsonType type = JsonType::null;
  bool is_true = false;   ///< a boolean
  bool is_whole = false;  ///< a number without sign, point and exponent, in `whole` as well
  double number = 0;      ///< the nearest double
  std::uint64_t whole = 0;
  std::size_t children = 0;  ///< elements or members
  std::size_t extent = 1;    ///< nodes: this one and all below
  TextPiece key{};           ///< of a member
  TextPiece string{};
};

/// A parsed text: the root first.
struct JsonTree {
  static constexpr std::size_t kStillOpen = std::numeric_limits<std::size_t>::max();  ///< an extent

  std::vector<JsonNode> nodes;
  std::string text;  ///< all keys and strings

  std::string_view view(TextPiece piece) const {
    return std::string_view(text).substr(piece.start, piece.length);
  }
  /// The member of that name of the object at `object`, or nothing.
  std::optional<std::size_t> find(std::size_t object, std::string_view key) const;
  /// "$.a.vertices[2]" for the node at `target`.
  std::string path_of(std::size_t target) const;
};

/// How a path goes on to a member of that name.
std::string path_step(std::string_view key);

/// The one JSON value that `text` holds, between any white space. Stricter than JSON where JSON is
/// vague: a repeated key, more than 64 keys, a number beyond double, nesting deeper than 32 levels
/// and a NUL byte are errors. Throws UserError that begins with a line and column, or with a path.
JsonTree parse_json(std::string_view text);

/// A value inside a parsed tree, read with checks. Whatever is wrong is a UserError that begins
/// with the value's path, such as $.a.vertices[2][0]. The tree must outlive the view.
class JsonView {
 public:
  explicit JsonView(const JsonTree& tree) : JsonView(tree, 0) {}

  bool is_null() const { return node().type == JsonType::null; }
  bool is_object() const { return node().type == JsonType::object; }

  /// Fails unless this is an object whose keys are all among `allowed`.
  void expect_keys(std::initializer_list<std::string_view> allowed) const;
  /// The names of an object's members.
  std::vector<std::string_view> keys() const;
  /// The member of that name; this must be an object.
  std::optional<JsonView> find(std::string_view key) const;
  JsonView at(std::string_view key) const;

  /// The length of an array; anything else fails with `expected` ("an array of two numbers").
  std::size_t length(std::string_view expected = "an array") const;
  /// The elements of an array, in one pass.
  std::vector<JsonView> elements(std::string_view expected = "an array") const;
  /// Element i of an array, i below its length; takes i steps.
  JsonView operator[](std::size_t i) const;

  bool boolean() const;
  double number() const;
  /// 0 or more; null stands for infinity, which JSON has not.
  double magnitude() const;
  /// The nearest double, then the nearest float; beyond the largest float is an error.
  float number_as_float() const;
  std::uint64_t whole_number() const;
  std::string_view string() const;

  [[noreturn]] void fail(std::string_view what) const;

 private:
  JsonView(const JsonTree& tree, std::size_t index) : tree_(&tree), index_(index) {}
  const JsonNode& node() const { return tree_->nodes[index_]; }
  void expect_type(JsonType type, std::string_view expected) const;

  const JsonTree* tree_;
  std::size_t index_;
};

}  // namespace manifuzz
