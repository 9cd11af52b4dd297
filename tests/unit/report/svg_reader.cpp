#include "unit/report/svg_reader.hpp"

#include <algorithm>
#include <stdexcept>

namespace manifuzz::test {
namespace {

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::vector<Element> read() {
    skip_declaration();
    skip_blanks();
    read_element();
    skip_blanks();
    if (!text_.empty()) fail("something behind the root");
    return std::move(elements_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(what + " at: " + std::string(text_.substr(0, 60)));
  }
  bool skip(std::string_view word) {
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }
  void expect(std::string_view word) {
    if (!skip(word)) fail("no " + std::string(word));
  }
  std::string take_until(std::string_view ends) {
    const std::size_t length = text_.find_first_of(ends);
    if (length == text_.npos) fail("no end");
    const std::string taken(text_.substr(0, length));
    text_.remove_prefix(length);
    return taken;
  }
  void skip_blanks() {
    text_.remove_prefix(std::min(text_.find_first_not_of(" \n"), text_.size()));
  }
  void skip_declaration() {
    expect("<?xml ");
    take_until("?");
    expect("?>");
  }

  std::string resolved(const std::string& raw) const {
    static const std::map<std::string, char> entities = {
        {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}};
    std::string out;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      if (raw[i] == '<') fail("a raw <");
      if (raw[i] != '&') {
        out += raw[i];
        continue;
      }
      const std::size_t end = raw.find(';', i);
      if (end == raw.npos || !entities.contains(raw.substr(i + 1, end - i - 1))) fail("a raw &");
      out += entities.at(raw.substr(i + 1, end - i - 1));
      i = end;
    }
    return out;
  }

  void read_attributes(Element& element) {
    for (skip_blanks(); !text_.starts_with('/') && !text_.starts_with('>'); skip_blanks()) {
      const std::string name = take_until("= >");
      expect("=\"");
      const std::string value = resolved(take_until("\""));
      expect("\"");
      if (!element.attributes.emplace(name, value).second) fail("twice " + name);
    }
  }

  void read_element() {
    expect("<");
    const std::size_t index = elements_.size();
    elements_.emplace_back();
    elements_[index].name = take_until(" />\n");
    read_attributes(elements_[index]);
    if (skip("/>")) return;
    expect(">");
    for (;;) {
      elements_[index].text += resolved(take_until("<"));
      if (skip("</")) break;
      read_element();
    }
    expect(elements_[index].name + ">");
  }

  std::string_view text_;
  std::vector<Element> elements_;
};

}  // namespace

bool Element::is(std::string_view element, std::string_view css) const {
  const auto found = attributes.find("class");
  return name == element && found != attributes.end() && found->second == css;
}

std::vector<Element> read_svg(std::string_view document) {
  return Reader(document).read();
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
