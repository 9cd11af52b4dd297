#include "sequence/sequence_judge.hpp"

#include <map>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "own_colliders/own_colliders.hpp"
#include "sequence/motions.hpp"
#include "unit/sequence/keepers.hpp"

namespace manifuzz::test {
namespace {

SequenceJudgement judged(const SequenceCollider& subject, const Sequence& sequence) {
  const auto answers = ask_sequence(subject, sequence);
  return judge_sequence(sequence, subject, answers);
}

/// How many sequences were wrong, by kind; `malformed` has none.
std::map<std::string, int> wrong_kinds(const SequenceCollider& subject, int sequences,
                                       std::string_view only = {}) {
  std::map<std::string, int> kinds;
  for (const Motion& motion : motions()) {
    if (!only.empty() && only != motion.name) continue;
    for (int i = 0; i < sequences; ++i) {
      const Bucket bucket = judged(subject, draw_sequence(3, motion, i)).bucket;
      if (bucket.fault == Fault::none) continue;
      ++kinds[bucket.verdict == Verdict::malformed ? "malformed"
                                                   : std::string(name_of(bucket.kind, kKindNames))];
    }
  }
  return kinds;
}

/// Whether these are the only kinds that a mistake shows in, and the first of them shows.
void check_kinds(Mistake mistake, std::string_view motion, const std::string& kind,
                 const std::set<std::string>& besides = {}) {
  const auto kinds = wrong_kinds(keeper_with(mistake), 300, motion);
  INFO("mistake " << static_cast<int>(mistake) << " in " << motion);
  for (const auto& [name, count] : kinds) {
    INFO(name << ' ' << count);
    CHECK((name == kind || besides.contains(name)));
  }
  CHECK(kinds.contains(kind));
  if (kinds.contains(kind)) CHECK(kinds.at(kind) >= 5);
}

}  // namespace

TEST_CASE("keepers without a mistake are right in every motion") {
  for (const SequenceCollider& subject :
       {keeper_with(Mistake::none), keeper_with(Mistake::keeps_nothing), make_cached(),
        make_cached64()}) {
    INFO(subject.declaration.name);
    CHECK(wrong_kinds(subject, 100).empty());
  }
}

TEST_CASE("a keeper with one mistake is wrong in the kind of its mistake") {
  check_kinds(Mistake::stale_normal, "turning_platform", "normal");
  check_kinds(Mistake::past_gap, "apart_and_back", "lingering");
  check_kinds(Mistake::past_drift, "sliding", "lingering");
  check_kinds(Mistake::past_turn, "rocking", "lingering");
  check_kinds(Mistake::stale_depth, "apart_and_back", "inconsistent");
  check_kinds(Mistake::drops_deepest, "rocking", "extent");
  check_kinds(Mistake::drops_end, "rocking", "extent");
  check_kinds(Mistake::false_birth, "sliding", "inconsistent", {"not_minimal", "witness", "depth"});
  check_kinds(Mistake::anchor_aside, "resting", "witness");
  check_kinds(Mistake::both_aside, "resting", "witness");
  check_kinds(Mistake::moves_anchors, "sliding", "position");
  check_kinds(Mistake::detects_no_more, "apart_and_back", "missed_contact", {"depth"});
  check_kinds(Mistake::shares_ids, "rocking", "malformed", {"extent", "normal"});
  check_kinds(Mistake::born_before, "sliding", "malformed");
  check_kinds(Mistake::too_many, "resting", "malformed");
}

TEST_CASE("what is lost, unsupported or not finite decides a sequence") {
  const Sequence sequence = draw_sequence(3, *find_motion("resting"), 0);
  const SequenceCollider subject = keeper_with(Mistake::none);
  auto answers = ask_sequence(subject, sequence);
  REQUIRE(answers.size() == sequence.frames.size());
  CHECK(judge_sequence(sequence, subject, answers).bucket.verdict == Verdict::agree);

  answers.resize(2);
  answers.push_back(Lost{Lost::How::timed_out, "it took too long"});
  SequenceJudgement judgement = judge_sequence(sequence, subject, answers);
  CHECK(judgement.bucket == bucket_of_lost(Verdict::timed_out, Fault::subject));
  CHECK(judgement.frame == 2);

  answers.back() = Unsupported{"never"};
  CHECK(judge_sequence(sequence, subject, answers).bucket.verdict == Verdict::unsupported);

  answers.back() = KeptManifold{{{.id = 1, .born = 2, .depth = std::nan("")}}};
  CHECK(judge_sequence(sequence, subject, answers).bucket.verdict == Verdict::malformed);
}

TEST_CASE("moving both bodies by a power of two, or a quarter turn, changes no verdict") {
  const SequenceCollider subject = make_cached_bullet();
  for (int i = 0; i < 100; ++i) {
    const Sequence sequence = draw_sequence(3, *find_motion("rocking"), i);
    Sequence moved = sequence;
    for (FramePoses& poses : moved.frames) {
      for (Pose<float>* const pose : {&poses.a, &poses.b}) {
        pose->position = {-pose->position.y(), pose->position.x()};
        pose->rotation = {-pose->rotation.y(), pose->rotation.x()};
      }
    }
    CHECK(judged(subject, sequence).bucket == judged(subject, moved).bucket);
  }
}

}  // namespace manifuzz::test
