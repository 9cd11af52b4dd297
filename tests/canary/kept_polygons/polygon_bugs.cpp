#include "canary/kept_polygons/polygon_bugs.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "canary/edits.hpp"
#include "sequence/motions.hpp"
#include "sequence/sequence_judge.hpp"
#include "support/named_tests.hpp"
#include "support/source_tree.hpp"

// Bugs planted into a keeper of polygons that gives both ends of each clip: the judge of sequences
// must find each of them, and nothing in the keeper without them.

namespace manifuzz::canary {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kSequences = 6000;

struct Planted {
  Bug bug;
  SequenceCollider (*make)() = nullptr;
};

std::map<std::string, Planted>& planted() {
  static std::map<std::string, Planted> bugs;
  return bugs;
}

bool is_unedited(const std::string& bug) {
  return bug.starts_with("unedited");
}

/// The motions in turn, of shapes that the keeper takes.
Sequence sequence_of(const SequenceCollider& subject, std::uint64_t number) {
  const Motion& motion = motions()[number % motions().size()];
  return draw_sequence(kSeed, motion, number / motions().size(),
                       [&](const Sequence& drawn) { return takes(subject, drawn); });
}

/// What the judge makes of the answers; none where they are right.
std::optional<std::string> blamed(const SequenceCollider& subject, const Sequence& sequence,
                                  const std::vector<KeptAnswer>& answers) {
  const SequenceJudgement judgement = judge_sequence(sequence, subject, answers);
  if (judgement.bucket.verdict == Verdict::agree) return std::nullopt;
  return to_string(judgement.bucket);
}

/// Says after how many sequences it is found.
bool is_found(const std::string& name, const Planted& one) {
  const SequenceCollider subject = one.make();
  for (std::uint64_t number = 0; number < kSequences; ++number) {
    const Sequence sequence = sequence_of(subject, number);
    const auto bucket = blamed(subject, sequence, ask_sequence(subject, sequence));
    if (!bucket) continue;
    fmt::print("{:<30} {}, after {} sequences\n", name, *bucket, number + 1);
    return true;
  }
  return false;
}

/// Whether both say the same of a point but for what is small to any of its figures.
bool is_same_point(const KeptPoint& p, const KeptPoint& q) {
  constexpr double small = 1e-5;
  return p.born == q.born && p.travels_with == q.travels_with &&
         std::abs(p.depth - q.depth) <= small && (p.normal - q.normal).norm() <= small &&
         (p.anchor_a - q.anchor_a).norm() <= small && (p.anchor_b - q.anchor_b).norm() <= small;
}

bool are_same(const KeptAnswer& p, const KeptAnswer& q) {
  const auto& one = std::get<KeptManifold>(p).points;
  const auto& other = std::get<KeptManifold>(q).points;
  return one.size() == other.size() && std::ranges::all_of(one, [&](const KeptPoint& point) {
           return std::ranges::any_of(other,
                                      [&](const auto& of) { return is_same_point(point, of); });
         });
}

}  // namespace

bool add_polygon_keepers(const std::vector<Bug>& bugs, SequenceCollider (*make)()) {
  for (const Bug& bug : bugs) {
    const std::string name = bug.name;
    const Planted one{bug, make};
    planted().emplace(name, one);
    test::add_test(name + (is_unedited(name) ? " is right" : " is found"), "[planted]", [=] {
      const Acting acting(bug);
      CHECK(is_found(name, one) == !is_unedited(name));
    });
  }
  return true;
}

}  // namespace manifuzz::canary

using namespace manifuzz;

TEST_CASE("every bug of the table of kept polygons is planted, at least 20") {
  const auto edits =
      canary::read_edits(test::source_dir() / "tests/canary/kept_polygons/edits.txt");
  CHECK(edits.size() >= 20);
  for (const canary::Edit& edit : edits) {
    CAPTURE(edit.bug);
    CHECK(canary::planted().contains(edit.bug));
  }
}

TEST_CASE(
    "each bug's sequences: how many it changes by more than 1e-5, and in how many it is found",
    "[.table]") {
  const canary::Planted& right = canary::planted().at("unedited_polygons");
  std::vector<std::vector<KeptAnswer>> of_right;
  for (std::uint64_t number = 0; number < canary::kSequences; ++number) {
    const canary::Acting acting(right.bug);
    const SequenceCollider subject = right.make();
    of_right.push_back(ask_sequence(subject, canary::sequence_of(subject, number)));
  }
  for (const auto& [name, one] : canary::planted()) {
    const canary::Acting acting(one.bug);
    const SequenceCollider subject = one.make();
    int changed = 0;
    int found = 0;
    for (std::uint64_t number = 0; number < canary::kSequences; ++number) {
      const Sequence sequence = canary::sequence_of(subject, number);
      const auto answers = ask_sequence(subject, sequence);
      changed += std::ranges::equal(answers, of_right[number], canary::are_same) ? 0 : 1;
      found += canary::blamed(subject, sequence, answers) ? 1 : 0;
    }
    fmt::print("{:<30} changes {:>5}, found {:>5}\n", name, changed, found);
  }
}
