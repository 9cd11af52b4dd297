#include <map>

#include <fmt/format.h>

#include "sequence/motions.hpp"
#include "unit/sequence/keepers.hpp"

namespace manifuzz::test {
namespace {

constexpr int kSequences = 200;

/// As what a mistake shows in a motion.
struct Expected {
  Mistake mistake;
  std::string_view motion;
  std::string kind;  ///< empty: it is right
  int least = 0;     ///< sequences of kSequences in which that kind decides: as measured, nearly
  std::set<std::string> besides{};
};

const std::vector<Expected>& expected() {
  static const std::vector<Expected> all = [] {
    std::vector<Expected> made{
        {Mistake::stale_normal, "turning_platform", "normal", 70},
        {Mistake::past_gap, "apart_and_back", "lingering", 80},
        {Mistake::past_drift, "sliding", "lingering", 47},
        {Mistake::past_turn, "rocking", "lingering", 80},
        {Mistake::stale_depth, "apart_and_back", "inconsistent", 78},
        {Mistake::drops_deepest, "rocking", "extent", 4},
        {Mistake::drops_end, "rocking", "extent", 30},
        {Mistake::false_birth, "sliding", "inconsistent", 6, {"not_minimal", "witness", "depth"}},
        {Mistake::anchor_aside, "resting", "witness", 155},
        {Mistake::both_aside, "resting", "witness", 155},
        {Mistake::moves_anchors, "sliding", "position", 15},
        {Mistake::detects_no_more, "apart_and_back", "missed_contact", 44, {"depth"}},
        {Mistake::detects_no_more, "rocking", "depth", 28, {"missed_contact"}},
        {Mistake::shares_ids, "rocking", "malformed", 60, {"extent", "normal"}},
        {Mistake::born_before, "sliding", "malformed", 140},
        {Mistake::too_many, "resting", "malformed", 200},
        {Mistake::one_depth, "rocking", "witness", 40, {"inconsistent"}},
        {Mistake::end_aside, "rocking", "witness", 25, {"inconsistent"}},
        {Mistake::new_beside_old, "sliding", "lingering", 30},
        {Mistake::wrong_carrier, "rocking", "normal", 60},
    };
    for (const Motion& motion : motions()) {
      made.push_back({Mistake::none, motion.name, ""});
      made.push_back({Mistake::keeps_nothing, motion.name, ""});
      made.push_back({Mistake::both_ends, motion.name, ""});
    }
    return made;
  }();
  return all;
}

/// How many sequences were wrong, by kind; `malformed` has none.
std::map<std::string, int> wrong_kinds(JudgeOfSequence judge, const Expected& of) {
  const SequenceCollider subject = keeper_with(of.mistake);
  std::map<std::string, int> kinds;
  for (int i = 0; i < kSequences; ++i) {
    const Sequence sequence = draw_sequence(3, *find_motion(of.motion), i);
    // As they are asked, but for this judge's own way to ask.
    std::vector<KeptAnswer> answers;
    const auto ask = subject.begin();
    for (std::size_t k = 0; k < sequence.frames.size(); ++k) answers.push_back(ask(sequence.at(k)));
    const Bucket bucket = judge(sequence, subject, answers);
    if (bucket.fault == Fault::none) continue;
    const bool is_malformed = bucket.verdict == Verdict::malformed;
    ++kinds[is_malformed ? "malformed" : std::string(name_of(bucket.kind, kKindNames))];
  }
  return kinds;
}

std::optional<std::string> complaint(JudgeOfSequence judge, const Expected& of) {
  const auto kinds = wrong_kinds(judge, of);
  const auto says = [&](const std::string& what, int count) {
    return fmt::format("mistake {} in {}: {} in {} of {} sequences", static_cast<int>(of.mistake),
                       of.motion, what, count, kSequences);
  };
  for (const auto& [kind, count] : kinds) {
    if (kind != of.kind && !of.besides.contains(kind)) return says(kind, count);
  }
  if (of.kind.empty()) return std::nullopt;
  const int count = kinds.contains(of.kind) ? kinds.at(of.kind) : 0;
  return count >= of.least ? std::nullopt : std::optional(says(of.kind, count));
}

}  // namespace

std::optional<std::string> complaint_about(JudgeOfSequence judge) {
  for (const Expected& of : expected()) {
    if (auto found = complaint(judge, of)) return found;
  }
  return std::nullopt;
}

}  // namespace manifuzz::test
