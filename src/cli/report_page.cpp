#include "cli/report_page.hpp"

#include "base/user_error.hpp"

namespace manifuzz {

std::string report_page(const RunFiles& files, NamedColliders& colliders, std::size_t maps_max,
                        const std::string& command) {
  Page page;
  page.command = command;
  page.errors = files.corpus.errors;
  for (const ResultFile& result : files.results) {
    page.results.push_back({result.path, std::string(result.kind), result.json});
  }
  Interruption interruption(kUntilSignal);
  try {
    page.cases = page_cases(files, colliders, maps_max, interruption);
  } catch (const Interrupted&) {
    throw UserError("the page: interrupted before it was done");
  }
  return page_html(page);
}

}  // namespace manifuzz
