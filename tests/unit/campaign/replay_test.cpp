#include "campaign/replay.hpp"

#include <catch2/catch.hpp>

#include "campaign/pairs/pair_trial.hpp"
#include "campaign/smoke.hpp"
#include "engines/colliders.hpp"

using namespace manifuzz;

namespace {

CorpusCase boxes(const std::string& bucket) {
  CorpusCase recorded;
  const std::vector<Vector2<float>> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const ConvexPolygon<float> box = make_polygon<float>(square);
  recorded.any = PairCase{{box, {}}, {box, {{1.5F, 0.25F}, {1, 0}}}};
  recorded.expect = Expectation{"clip", "box2d", "", bucket, {}};
  return recorded;
}

Collider blind() {
  Collider collider = find_collider("clip");
  collider.collide = [](const PairCase&) { return Answer(Manifold<double>{}); };
  return collider;
}

Replayed replay(const CorpusCase& recorded, const Collider& subject) {
  Interruption interruption;
  return replay_case(recorded, *trial_of_pairs(subject, find_collider("box2d")),
                     known_of({&recorded, 1}, "2026-11-23"), interruption);
}

}  // namespace

TEST_CASE("a case passes when the subject is right and the bucket is the recorded one") {
  CHECK(replay(boxes("none/agree/none/none/a"), find_collider("clip")).passed);
}

TEST_CASE("another bucket than the recorded one fails, and is named") {
  const Replayed replayed = replay(boxes("none/tie/count/incident/b"), find_collider("clip"));
  CHECK_FALSE(replayed.passed);
  CHECK(replayed.expected == "none/tie/count/incident/b");
  CHECK(replayed.got == "none/agree/none/none/a");
}

TEST_CASE("the recorded bucket is not asked of another subject") {
  CHECK(replay(boxes("none/tie/count/incident/b"), find_collider("clip64")).passed);
}

TEST_CASE("a wrong subject fails whatever was recorded") {
  CHECK_FALSE(replay(boxes("none/agree/none/none/a"), blind()).passed);
  CHECK_FALSE(replay(boxes("subject/subject_wrong/missed_contact/none/a"), blind()).passed);
}

TEST_CASE("a regression passes once the subject is right") {
  CHECK(replay(boxes("subject/subject_wrong/missed_contact/none/a"), find_collider("clip")).passed);
}

TEST_CASE("a case that a collider cannot take has neither passed nor failed") {
  CorpusCase recorded = boxes("none/agree/none/none/a");
  std::get<PairCase>(recorded.any).b.polygon =
      make_polygon<float>(std::vector<Vector2<float>>{{0, 0}}, 1);
  const auto is_left_out = [&] {
    const Replayed replayed = replay(recorded, find_collider("gjk-clip"));
    return replayed.is_unsupported && !replayed.passed && !replayed.has_failed() &&
           !replayed.is_stale;
  };
  CHECK(is_left_out());
  recorded.path = "witness-box2d-coincident-points.json";  // the oracle's mistake is not gone
  CHECK(is_left_out());
  recorded.accepted = Acceptance{.because = "so"};
  recorded.expect = Expectation{"gjk-clip", "box2d", "", "subject/subject_wrong/depth/none/a", {}};
  CHECK(is_left_out());
  recorded.property = "never-empty";
  CHECK(is_left_out());
}

TEST_CASE("a case that was answered and is taken no more fails") {
  CorpusCase recorded = boxes("none/agree/none/none/a");
  std::get<PairCase>(recorded.any).b.polygon =
      make_polygon<float>(std::vector<Vector2<float>>{{0, 0}}, 1);
  recorded.expect->subject = "gjk-clip";
  CHECK(replay(recorded, find_collider("gjk-clip")).has_failed());
  recorded.expect->bucket = "none/unsupported/none/none/a";
  CHECK(replay(recorded, find_collider("gjk-clip")).is_unsupported);
}

TEST_CASE("a case of a property must pass that property") {
  CorpusCase recorded = boxes("");
  recorded.expect.reset();
  recorded.property = "never-empty";
  CHECK(replay(recorded, find_collider("clip")).passed);
  CHECK_FALSE(replay(recorded, blind()).passed);
  recorded.property = "no-such-property";
  CHECK_FALSE(replay(recorded, find_collider("clip")).passed);
}

TEST_CASE("a subject that is wrong as recorded passes where that is accepted, and no worse") {
  const std::string bucket = "subject/subject_wrong/missed_contact/reference/a";
  for (const char* error_class : {"", "/gross"}) {
    CorpusCase recorded = boxes(bucket + error_class);
    recorded.accepted = Acceptance{.because = "so", .up_to = 1};
    const Replayed accepted = replay(recorded, blind());
    CHECK(accepted.passed);
    CHECK(accepted.is_accepted);
    CHECK_FALSE(accepted.is_stale);
    recorded.accepted->up_to = 1e-3;
    const Replayed worse = replay(recorded, blind());
    CHECK_FALSE(worse.passed);
    CHECK(worse.got.starts_with(bucket + "/gross: worse than is accepted"));
  }
}

TEST_CASE("a subject that is wrong in another way than was accepted fails") {
  for (const char* bucket :
       {"subject/subject_wrong/missed_contact/reference/a/fine",
        "subject/subject_wrong/depth/none/a/gross", "subject/crashed/none/none/a"}) {
    CorpusCase recorded = boxes(bucket);
    recorded.accepted = Acceptance{.because = "so"};
    const Replayed other = replay(recorded, blind());
    CHECK_FALSE(other.passed);
    CHECK_FALSE(other.is_accepted);
  }
}

TEST_CASE("what was accepted and comes no more passes, and is stale, the oracle's mistakes too") {
  for (const char* bucket : {"subject/subject_wrong/missed_contact/reference/a/gross",
                             "oracle/oracle_wrong/depth/none/a/gross"}) {
    CorpusCase recorded = boxes(bucket);
    recorded.accepted = Acceptance{.because = "so"};
    const Replayed gone = replay(recorded, find_collider("clip"));
    CHECK(gone.passed);
    CHECK(gone.is_stale);
    CHECK_FALSE(gone.is_accepted);
  }
  CHECK_FALSE(
      replay(boxes("oracle/oracle_wrong/depth/none/a/gross"), find_collider("clip")).passed);
}

TEST_CASE("a property that fails passes where that is accepted, and is stale once it holds") {
  CorpusCase recorded = boxes("");
  recorded.property = "never-empty";
  recorded.accepted = Acceptance{.because = "so", .up_to = 1};
  const Replayed accepted = replay(recorded, blind());
  CHECK(accepted.passed);
  CHECK(accepted.is_accepted);
  CHECK(replay(recorded, find_collider("clip")).is_stale);
  recorded.accepted->up_to = 1e-3;
  CHECK_FALSE(replay(recorded, blind()).passed);
}

TEST_CASE("smoke's parts share what two starts of the colliders leave of its time") {
  SmokePlan plan;
  plan.start = Clock::now();
  plan.seconds = 18;
  const auto seconds_at = [&](double share, int starts) {
    return std::chrono::duration<double>(*plan.at(share, starts) - plan.start).count();
  };
  CHECK(seconds_at(0.25, 1) == Approx(4.5));
  CHECK(seconds_at(0.75, 2) == Approx(13.5));
  plan.start_seconds = 5;
  CHECK(seconds_at(0.25, 1) == Approx(7));
  CHECK(seconds_at(0.75, 2) == Approx(16));
  for (const double start : {0.0, 5.0, 9.0, 10.0}) {
    plan.start_seconds = start;
    CHECK(seconds_at(1, 2) == Approx(18));
  }
}
