#include <csignal>
#include <thread>

#include <catch2/catch.hpp>

#include "campaign/replay.hpp"
#include "campaign/sequences/keeper_trial.hpp"
#include "campaign/sequences/sequence_case.hpp"
#include "campaign/sequences/sequence_work.hpp"
#include "sequence/motions.hpp"
#include "unit/sequence/keepers.hpp"

using namespace manifuzz;
using test::keeper_with;
using test::Mistake;

namespace {

/// The first sequence of a motion of which that kind is what is wrong.
Sequence first_with(Kind kind, const std::string& motion, const SequenceCollider& subject) {
  for (std::uint64_t index = 0; index < 500; ++index) {
    const Sequence sequence = draw_sequence(1, *find_motion(motion), index);
    const auto judgement = judge_sequence(sequence, subject, ask_sequence(subject, sequence));
    if (judgement.bucket.kind == kind) return sequence;
  }
  FAIL("no such sequence");
  return {};
}

/// Answers nothing, but in one frame does `otherwise`.
SequenceCollider troubled(std::size_t at, const std::function<KeptAnswer()>& otherwise) {
  SequenceCollider subject = keeper_with(Mistake::none);
  subject.begin = [at, otherwise] {
    return [at, otherwise, frame = std::size_t{0}](const PairCase&) mutable -> KeptAnswer {
      return frame++ == at ? otherwise() : KeptManifold{};
    };
  };
  return subject;
}

SequenceCollider crashing(std::size_t at) {
  return troubled(at, []() -> KeptAnswer {
    std::raise(SIGKILL);
    return KeptManifold{};
  });
}

Sequence apart_for(std::size_t frames) {
  Sequence sequence = draw_sequence(1, motions().front(), 0);
  sequence.frames.assign(frames, {{}, {{1000, 0}, {1, 0}}});
  return sequence;
}

}  // namespace

TEST_CASE("a stale normal shrinks to two frames, the same every time") {
  const SequenceCollider subject = keeper_with(Mistake::stale_normal);
  const Sequence sequence = first_with(Kind::normal, "turning_platform", subject);
  REQUIRE(sequence.frames.size() > 2);
  Interruption interruption;
  const ShrunkSequence smallest = shrink_finding(sequence, subject, interruption);
  CHECK(smallest.complete);
  CHECK(smallest.sequence.frames.size() == 2);
  const auto root = judge_in_child(sequence, subject, interruption);
  const auto shrunk = judge_in_child(smallest.sequence, subject, interruption);
  CHECK(is_alike(counted(shrunk), counted(root)));
  CHECK(complexity(smallest.sequence) < complexity(sequence));
  CHECK(shrink_finding(sequence, subject, interruption).sequence == smallest.sequence);
}

TEST_CASE("what is wrong at birth shrinks to one frame") {
  const SequenceCollider subject = keeper_with(Mistake::both_aside);
  const Sequence sequence = first_with(Kind::witness, "sliding", subject);
  Interruption interruption;
  CHECK(shrink_finding(sequence, subject, interruption).sequence.frames.size() == 1);
}

TEST_CASE("shrinking ends at its limit, with what it has") {
  int asked = 0;
  const ShrunkSequence shrunk = shrink(
      apart_for(40), [&](const Sequence&) { return ++asked > 0; }, 3);
  CHECK_FALSE(shrunk.complete);
  CHECK(asked == 3);
  CHECK(shrunk.sequence.frames.size() < 40);
}

TEST_CASE("a keeper that dies or hangs in a frame is a verdict, and its answers before it stay",
          "[longer]") {
  Interruption interruption;
  const Sequence sequence = apart_for(5);
  const auto answers = ask_in_child(crashing(3), sequence, interruption);
  REQUIRE(answers.size() == 4);
  CHECK(std::holds_alternative<KeptManifold>(answers[2]));
  CHECK(std::get<Lost>(answers[3]).how == Lost::How::crashed);
  CHECK(judge_in_child(sequence, crashing(3), interruption).bucket.verdict == Verdict::crashed);
  const SequenceCollider hanging = troubled(0, []() -> KeptAnswer {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return KeptManifold{};
  });
  CHECK(judge_in_child(sequence, hanging, interruption).bucket.verdict == Verdict::timed_out);
}

TEST_CASE("a crash shrinks to the frames that it takes") {
  Interruption interruption;
  CHECK(shrink_finding(apart_for(8), crashing(2), interruption).sequence.frames.size() == 3);
}

TEST_CASE("a sequence that is replayed passes by the rules of cases") {
  const SequenceCollider wrong = keeper_with(Mistake::stale_normal);
  Interruption interruption;
  const Sequence sequence = first_with(Kind::normal, "turning_platform", wrong);
  const KeeperTrial trial(wrong);
  std::vector<CorpusCase> saved{trial.unasked(sequence, trial.judge(sequence, interruption))};
  const auto replay = [&](const SequenceCollider& subject) {
    return replay_case(saved.front(), KeeperTrial(subject), known_of(saved, "2026-11-23"),
                       interruption);
  };
  CHECK(saved.front().expect->bucket.starts_with("subject/subject_wrong/normal/"));
  CHECK_FALSE(replay(wrong).passed);
  SequenceCollider right = keeper_with(Mistake::none);
  right.declaration.name = wrong.declaration.name;
  CHECK(replay(right).passed);
  saved.front().accepted = Acceptance{.because = "known"};
  CHECK(replay(wrong).is_accepted);
  CHECK(replay(right).is_stale);
}

TEST_CASE("a keeper that is not there is not asked, and one that is not installed fails nothing") {
  std::vector<CorpusCase> saved(1);
  saved.front().any = apart_for(2);
  saved.front().expect.emplace().subject = "somebody's";
  Interruption interruption;
  const TrialOf none = trials_of_keepers([](const auto&) { return std::nullopt; }, {});
  CHECK(replay_cases(saved, none, {}, interruption).unasked.size() == 1);
  const TrialOf absent = trials_of_keepers([](const auto&) { return SequenceCollider{}; }, {});
  const ReplayRun run = replay_cases(saved, absent, {}, interruption);
  CHECK(run.unsupported() == 1);
  CHECK(run.failed() == 0);
}

TEST_CASE("a campaign draws sequences of shapes that the keeper declares") {
  SequenceCollider subject = keeper_with(Mistake::none);
  subject.declaration.min_vertices = kMinVertices;
  subject.declaration.takes_round = false;
  subject.declaration.takes_radius = false;
  subject.declaration.max_vertices = 5;
  Plan plan;
  plan.seed = 1;
  plan_sequences(plan, subject, {});
  CHECK(plan.regimes.size() == motions().size());
  for (CaseNumber number = 0; number < 400; ++number) {
    const PairCase pair = std::get<Sequence>(plan.work->draw(plan, number)).at(0);
    REQUIRE_FALSE(is_round(pair));
    REQUIRE(total_radius(pair) == 0);
    REQUIRE(std::max(pair.a.polygon.count, pair.b.polygon.count) <= 5);
  }
}

TEST_CASE("motions that have no shapes which a keeper takes are left out, unless they are named") {
  SequenceCollider of_circles = keeper_with(Mistake::none);
  of_circles.declaration.min_vertices = 1;
  of_circles.declaration.takes_round = true;
  for (const ShapeFamily other :
       {ShapeFamily::capsule, ShapeFamily::polygon, ShapeFamily::rounded}) {
    for (const ShapeFamily any :
         {ShapeFamily::circle, ShapeFamily::capsule, ShapeFamily::polygon, ShapeFamily::rounded}) {
      of_circles.declaration.declines.push_back({other, any});
    }
  }
  of_circles.declaration.max_vertices = 1;
  Plan plan;
  plan_sequences(plan, of_circles, {});
  // What rolls has a floor under it.
  CHECK(plan.regimes.size() == motions().size() - 1);
  const std::string rolling = "rolling";
  Plan named;
  plan_sequences(named, of_circles, {&rolling, 1});
  Interruption interruption;
  const auto untaken = std::get<Sequence>(named.work->draw(named, 0));
  CHECK(judge_in_child(untaken, of_circles, interruption).bucket.verdict == Verdict::unsupported);
}
