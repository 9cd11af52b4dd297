#include <optional>

#include <catch2/catch.hpp>

#include "base/user_error.hpp"
#include "cli/colliders.hpp"
#include "corpus/corpus.hpp"
#include "judging/judge.hpp"
#include "support/named_tests.hpp"

// Each entry of the ledger is alive: its witness still shows the deviation it names.

using namespace manifuzz;

namespace {

void expect_alive(const LedgerEntry& entry) {
  const std::string path =
      std::string(MANIFUZZ_SOURCE_DIR) + "/corpus/" + std::string(entry.witness);
  const CorpusCase witness = read_case_file(path);
  std::optional<Collider> oracle;
  try {
    oracle = find_collider(entry.collider);
  } catch (const UserError& error) {  // without node there are no engines of npm's
    WARN("skipped: " << error.what());
    return;
  }
  const std::string subject = witness.expect ? witness.expect->subject : "clip";
  const Judgement judgement = judge(witness.pair, find_collider(subject), *oracle);
  CHECK(judgement.bucket.verdict == Verdict::known);
  REQUIRE(judgement.explanation != nullptr);
  CHECK(judgement.explanation->id == entry.id);
}

[[maybe_unused]] const bool registered = [] {
  for (const LedgerEntry& entry : ledger()) {
    test::add_test("the witness of " + std::string(entry.id) + " still shows it", "[ledger]",
                   [&entry] { expect_alive(entry); });
  }
  return true;
}();

}  // namespace
