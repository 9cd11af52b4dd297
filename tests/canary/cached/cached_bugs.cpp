#include "canary/cached/cached_bugs.hpp"

#include <set>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "canary/edits.hpp"
#include "sequence/motions.hpp"
#include "sequence/sequence_judge.hpp"
#include "support/named_tests.hpp"
#include "support/source_tree.hpp"

// Bugs planted into what keeps points over frames: the judge of sequences must blame them.

namespace manifuzz::canary {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kSequences = 20'000;
constexpr std::uint64_t kSequencesUnedited = 2000;

bool is_unedited(const std::string& bug) {
  return bug.starts_with("unedited");
}

std::set<std::string>& planted() {
  static std::set<std::string> bugs;
  return bugs;
}

/// What the judge blames a collider for; none where all is well.
std::optional<std::string> blamed(const SequenceCollider& subject, const Sequence& sequence) {
  const auto answers = ask_sequence(subject, sequence);
  const SequenceJudgement judgement = judge_sequence(sequence, subject, answers);
  if (is_failure(judgement.bucket)) return to_string(judgement.bucket);
  return std::nullopt;
}

/// Asks one after the other, the motions in turn; says what shows the bug.
bool is_caught(const std::string& bug, const std::vector<MakeKeeper>& makes) {
  const std::uint64_t most = is_unedited(bug) ? kSequencesUnedited : kSequences;
  for (std::uint64_t number = 0; number < most; ++number) {
    const Motion& motion = motions()[number % motions().size()];
    const Sequence sequence = draw_sequence(kSeed, motion, number / motions().size());
    for (const MakeKeeper make : makes) {
      const SequenceCollider subject = make();
      const auto bucket = blamed(subject, sequence);
      if (!bucket) continue;
      fmt::print("{:<30} {}: {}, {} {}, after {} sequences\n", bug, subject.declaration.name,
                 *bucket, motion.name, number / motions().size(), number + 1);
      return true;
    }
  }
  return false;
}

}  // namespace

bool add_keepers(const std::vector<Bug>& bugs, const std::vector<MakeKeeper>& makes) {
  for (const Bug& bug : bugs) {
    const std::string name = bug.name;
    planted().insert(name);
    const std::string verb = is_unedited(name) ? " is not caught" : " is caught";
    test::add_test(name + verb, "[planted]", [=] {
      const Acting acting(bug);
      CHECK(is_caught(name, makes) == !is_unedited(name));
    });
  }
  return true;
}

}  // namespace manifuzz::canary

using namespace manifuzz;

TEST_CASE("every bug of the table of kept points is planted, at least 20") {
  const auto edits = canary::read_edits(test::source_dir() / "tests/canary/cached/edits.txt");
  CHECK(edits.size() >= 20);
  for (const canary::Edit& edit : edits) {
    CAPTURE(edit.bug);
    CHECK(canary::planted().contains(edit.bug));
  }
}
