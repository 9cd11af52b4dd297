#include "unit/report/svg_reader.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <stdexcept>

#include <catch2/catch.hpp>

namespace manifuzz::test {
namespace {

void read(std::vector<Element>& elements, const pugi::xml_node& node) {
  Element element{node.name(), {}, node.text().get()};
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    if (!element.attributes.emplace(attribute.name(), attribute.value()).second) {
      throw std::runtime_error(std::string("twice ") + attribute.name());
    }
  }
  elements.push_back(element);
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_element) read(elements, child);
  }
}

}  // namespace

bool Element::is(std::string_view element, std::string_view css) const {
  const auto found = attributes.find("class");
  return name == element && found != attributes.end() && found->second == css;
}

std::vector<Element> read_svg(std::string_view document) {
  pugi::xml_document parsed;
  const auto result = parsed.load_buffer(document.data(), document.size());
  if (!result) throw std::runtime_error(result.description());
  const pugi::xml_node root = parsed.document_element();
  if (!root || root.next_sibling()) throw std::runtime_error("not one root");
  std::vector<Element> elements;
  read(elements, root);
  return elements;
}

std::vector<Element> select(const std::vector<Element>& elements, std::string_view name,
                            std::string_view css) {
  std::vector<Element> chosen;
  std::copy_if(elements.begin(), elements.end(), std::back_inserter(chosen),
               [&](const Element& element) { return element.is(name, css); });
  return chosen;
}

std::string all_text(const std::vector<Element>& elements) {
  std::string text;
  for (const Element& element : elements) {
    if (element.name == "text") text += element.text + '\n';
  }
  return text;
}

Font font_of(const Element& text) {
  return {text.number("font-size"), text.attributes.contains("font-weight")};
}

void check_numbers(const std::string& svg) {
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf,") == std::string::npos);
  CHECK(svg.find("\"inf") == std::string::npos);
  CHECK(svg.find("\"-inf") == std::string::npos);
}

namespace {

/// Rectangles and texts that leave the canvas, labels that cover each other.
std::vector<std::string> misplaced(const std::vector<Element>& elements) {
  const Box canvas{0, 0, elements.front().number("width"), elements.front().number("height")};
  std::vector<std::string> found;
  std::vector<Box> labels;
  for (const Element& element : elements) {
    if (element.name == "rect" && !canvas.contains(element.box())) found.push_back("a rect");
    if (element.is("rect", "label")) labels.push_back(element.box().grown(-0.01));  // of rounding
    if (element.name != "text") continue;
    const double width = text_width(element.text, font_of(element));
    const double size = element.number("font-size");
    const Box box{element.number("x"), element.number("y") - size, width, size};
    if (!canvas.contains(box)) found.push_back(element.text);
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (labels[i].overlaps(labels[j])) found.push_back("a label on another");
    }
  }
  return found;
}

}  // namespace

void check_layout(const std::vector<Element>& elements) {
  const auto found = misplaced(elements);
  CAPTURE(found);
  CHECK(found.empty());
}

}  // namespace manifuzz::test
