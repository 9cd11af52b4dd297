#include <algorithm>
#include <filesystem>
#include <map>

#include <catch2/catch.hpp>

#include "base/file.hpp"
#include "campaign/plan.hpp"
#include "judging/compare.hpp"
#include "judging/ledger.hpp"
#include "report/picture/pictures.hpp"
#include "report/words.hpp"
#include "support/installed_collider.hpp"
#include "support/source_tree.hpp"

// The reports beside the witnesses are what `show --upstream` says today, and the pictures beside
// the defects what `show --svg` draws.

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

TEST_CASE("every picture of a defect is what show draws of it") {
  std::map<std::string, std::optional<Collider>> asked;
  int compared = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(source_dir() / "corpus/defects")) {
    if (entry.path().extension() != ".svg") continue;
    auto file = entry.path();
    file.replace_extension(".json");
    CAPTURE(file);
    const CorpusCase given = read_case_file(file.string(), CaseKind::either);
    REQUIRE(given.expect);
    for (const std::string& name : {given.expect->subject, given.expect->oracle}) {
      if (!asked.contains(name)) asked.emplace(name, collider_with_ledger(name));
    }
    const auto& subject = asked.at(given.expect->subject);
    const auto& oracle = asked.at(given.expect->oracle);
    if (!subject || !oracle) continue;
    Interruption interruption;
    CHECK(case_svg(judged_case(given, *subject, *oracle, interruption)) ==
          InputFile(entry.path().string()).read_all());
    ++compared;
  }
  CHECK(compared > 0);
}
