#include "unit/report/svg_reader.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <stdexcept>

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

}  // namespace manifuzz::test
