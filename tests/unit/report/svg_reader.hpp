#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "report/picture/drawing.hpp"

namespace manifuzz::test {

/// An element of an SVG document, in the document's order.
struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< directly inside, entities resolved

  double number(const std::string& attribute) const { return std::stod(attributes.at(attribute)); }
  Box box() const { return {number("x"), number("y"), number("width"), number("height")}; }
  bool is(std::string_view element, std::string_view css) const;
};

/// Every element. Throws std::runtime_error where the document is not well-formed: tags that do not
/// balance, attributes without quotes or twice, a raw `<`, anything behind the one root.
std::vector<Element> read_svg(std::string_view document);

/// The elements of that name with that class.
std::vector<Element> select(const std::vector<Element>& elements, std::string_view name,
                            std::string_view css);

/// Every text of the document, a line each.
std::string all_text(const std::vector<Element>& elements);

Font font_of(const Element& text);

/// Checks that every number of the document is one.
void check_numbers(const std::string& svg);

/// Checks that no rectangle and no text leaves the canvas, and no label covers another.
void check_layout(const std::vector<Element>& elements);

}  // namespace manifuzz::test
