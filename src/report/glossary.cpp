#include "report/glossary.hpp"

#include <fmt/format.h>

#include "report/texts.hpp"

namespace manifuzz {

std::vector<Word> glossary() {
  std::vector<Word> words;
  for (std::string_view rest = kGlossary; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    const std::size_t colon = line.find(": ");
    words.push_back({line.substr(0, colon), line.substr(colon + 2)});
    rest.remove_prefix(line.size() + 1);
  }
  return words;
}

std::string glossary_text() {
  std::string text;
  for (const auto& [word, meaning] : glossary()) text += fmt::format("{:<10} {}\n", word, meaning);
  return text;
}

}  // namespace manifuzz
