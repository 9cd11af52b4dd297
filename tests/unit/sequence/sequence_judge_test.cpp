#include "sequence/sequence_judge.hpp"

#include <cmath>

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

Bucket bucket_of(const Sequence& sequence, const SequenceCollider& subject,
                 std::span<const KeptAnswer> answers) {
  return judge_sequence(sequence, subject, answers).bucket;
}

}  // namespace

TEST_CASE("keepers are right without a mistake, and wrong in the kind of theirs with one") {
  const auto complaint = complaint_about(bucket_of);
  INFO(complaint.value_or(""));
  CHECK_FALSE(complaint.has_value());
}

TEST_CASE("what cached keeps is right in every motion") {
  for (const SequenceCollider& subject : {make_cached(), make_cached64()}) {
    for (const Motion& motion : motions()) {
      for (int i = 0; i < 100; ++i) {
        INFO(subject.declaration.name << ' ' << motion.name << ' ' << i);
        const Bucket bucket = judged(subject, draw_sequence(3, motion, i)).bucket;
        REQUIRE(bucket.fault == Fault::none);
      }
    }
  }
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
