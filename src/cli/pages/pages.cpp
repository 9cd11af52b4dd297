#include "cli/pages/pages.hpp"

#include "cli/pages/completions.hpp"
#include "cli/pages/man_page.hpp"
#include "cli/pages/words_of_help.hpp"
#include "report/glossary.hpp"

namespace manifuzz {

bool has_all_options(std::string_view name) {
  return name == "man" || name == "bash" || name == "zsh" || name == "fish";
}

bool is_page(std::string_view name) {
  return name == "words" || has_all_options(name);
}

std::string page(const CLI::App& app, std::string_view name) {
  if (name == "words") return glossary_text();
  const auto program = words_of_help(app);
  if (name == "bash") return bash_completion(program);
  if (name == "zsh") return zsh_completion(program);
  if (name == "fish") return fish_completion(program);
  return man_page(program, MANIFUZZ_VERSION);
}

}  // namespace manifuzz
