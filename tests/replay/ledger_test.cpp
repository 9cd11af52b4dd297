#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "judging/judge.hpp"
#include "support/installed_collider.hpp"
#include "support/named_tests.hpp"

// Each entry of the ledger is alive: its witness still shows the deviation it names.

using namespace manifuzz;

namespace {

void check_alive(const LedgerEntry& entry) {
  const auto oracle = test::installed_collider(entry.collider);
  if (!oracle) return;
  const auto path = test::source_dir() / "corpus" / witness_of(entry);
  const CorpusCase witness = read_case_file(path.string());
  const std::string subject = witness.expect ? witness.expect->subject : "clip";
  const Judgement judgement = judge(witness.pair, find_collider(subject), *oracle);
  CHECK(judgement.bucket.verdict == Verdict::known);
  REQUIRE(judgement.explanation != nullptr);
  CHECK(judgement.explanation->id == entry.id);
}

[[maybe_unused]] const bool registered = [] {
  for (const LedgerEntry& entry : ledger()) {
    test::add_test("the witness of " + std::string(entry.id) + " still shows it", "[ledger]",
                   [&entry] { check_alive(entry); });
  }
  return true;
}();

}  // namespace
