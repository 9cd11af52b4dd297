#include "cli/report_page.hpp"

#include "cases/text.hpp"

namespace manifuzz {

std::string report_page(const RunFiles& files, NamedColliders& colliders, std::size_t maps_max) {
  Page page;
  page.errors = files.corpus.errors;
  for (const Result& result : files.results) {
    page.results.push_back({result.path, std::string(result.kind), result.json});
  }
  Interruption interruption;
  page.cases = page_cases(files, colliders, maps_max, interruption);
  return page_html(page);
}

}  // namespace manifuzz
