#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "base/file.hpp"
#include "campaign/plan.hpp"
#include "judging/compare.hpp"
#include "judging/ledger.hpp"
#include "report/words.hpp"
#include "support/installed_collider.hpp"
#include "support/source_tree.hpp"

// The reports beside the witnesses are what `show --upstream` says today.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

constexpr int kLinesMax = 30;

/// As scripts/reports asks for it.
std::string report_on(const std::filesystem::path& file, const Collider& oracle) {
  const CorpusCase given = read_case_file(file.string(), CaseKind::either);
  Interruption interruption;
  const std::string subject = given.expect->subject;
  return upstream_report(judged_case(given, find_collider(subject), oracle, interruption),
                         "--subject " + subject + " --oracle " + oracle.declaration.name);
}

}  // namespace

TEST_CASE("every defect that is a bug has a report, up to date and short") {
  std::size_t compared = 0;
  std::string engine;
  std::optional<Collider> oracle;
  for (const LedgerEntry& entry : ledger()) {
    const auto witness = source_dir() / "corpus" / witness_of(entry);
    auto written = witness;
    written.replace_extension(".md");
    CAPTURE(entry.id);
    CHECK(std::filesystem::exists(written) == !entry.is_no_bug);
    if (!std::filesystem::exists(written)) continue;
    if (entry.collider != engine) oracle = installed_collider(entry.collider);
    engine = entry.collider;
    if (!oracle) continue;
    const std::string text = InputFile(written.string()).read_all();
    CHECK(std::ranges::count(text, '\n') <= kLinesMax);
    CHECK(report_on(witness, *oracle) == text);
    ++compared;
  }
  CHECK(compared > 0);
}
