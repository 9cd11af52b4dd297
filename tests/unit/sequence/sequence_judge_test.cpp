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

namespace {

/// A box of width 2, tilted by 0.01, in a floor: its lower corners are 0.10995 and 0.08995 deep.
Sequence tilted_box() {
  const Vector2<float> floor[] = {{-10, -1}, {10, -1}, {10, 0}, {-10, 0}};
  const Vector2<float> box[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const FramePoses poses{{{0, 0}, {1, 0}}, {{0, 0.9F}, {0.99995F, 0.0099998333F}}};
  return {make_polygon<float>(floor), make_polygon<float>(box), {poses}};
}

/// Its lower corners as new points, the deeper one first.
std::vector<KeptPoint> corners_of(const Sequence& sequence) {
  std::vector<KeptPoint> points;
  for (const int corner : {0, 1}) {
    const Vector2<double> on_b = sequence.b.vertices[corner].cast<double>();
    const Vector2<double> place =
        transform(Pose<double>{sequence.frames[0].b.position.cast<double>(),
                               sequence.frames[0].b.rotation.cast<double>()},
                  on_b);
    points.push_back({.id = corner,
                      .born = 0,
                      .anchor_a = {place.x(), 0},
                      .anchor_b = on_b,
                      .normal = {0, 1},
                      .depth = -place.y()});
  }
  return points;
}

SequenceCollider giving_points(Claims claims) {
  SequenceCollider subject;
  subject.declaration.name = "points";
  subject.declaration.scalar = ScalarType::float64;
  subject.declaration.claims = claims;
  return subject;
}

Kind kind_of(Claims claims, std::vector<KeptPoint> points) {
  const Sequence sequence = tilted_box();
  const std::vector<KeptAnswer> answers{KeptManifold{std::move(points)}};
  return judge_sequence(sequence, giving_points(claims), answers).bucket.kind;
}

}  // namespace

TEST_CASE("both ends of a contact are right as they are detected, the shallower one too") {
  const auto points = corners_of(tilted_box());
  CHECK(points[0].depth == Approx(0.10995).margin(1e-5));
  CHECK(points[1].depth == Approx(0.08995).margin(1e-5));
  CHECK(kind_of(Claims::manifold, points) == Kind::none);
  CHECK(kind_of(Claims::manifold, {points[0]}) == Kind::none);
  CHECK(kind_of(Claims::point, {points[0]}) == Kind::none);

  // Without the deepest the frame is wrong, whatever each point is.
  CHECK(kind_of(Claims::manifold, {points[1]}) == Kind::depth);
  // Whoever claims one point claims the deepest.
  CHECK(kind_of(Claims::point, points) == Kind::inconsistent);

  auto as_deep = points;
  as_deep[1].depth = points[0].depth;
  as_deep[1].anchor_a.y() = points[0].depth - points[1].depth;
  CHECK(kind_of(Claims::manifold, as_deep) == Kind::witness);
  auto beyond = points;
  beyond[1].anchor_a.x() += 0.5;
  CHECK(kind_of(Claims::manifold, beyond) == Kind::witness);
  auto tilted = points;
  tilted[1].normal = {0.6, 0.8};
  CHECK(kind_of(Claims::manifold, tilted) == Kind::not_minimal);
  auto longer = points;
  longer[1].normal = {0, 1.1};
  CHECK(kind_of(Claims::manifold, longer) == Kind::normal);
}

TEST_CASE("a wrong shallower end is as wrong as it is off") {
  const Sequence sequence = tilted_box();
  auto points = corners_of(sequence);
  points[1].depth += 0.01;
  points[1].anchor_a.y() += 0.01;
  const std::vector<KeptAnswer> answers{KeptManifold{points}};
  const SequenceJudgement judgement =
      judge_sequence(sequence, giving_points(Claims::manifold), answers);
  CHECK(judgement.bucket.kind == Kind::witness);
  CHECK(judgement.magnitude == Approx(0.01 / size(sequence.at(0))));
}

TEST_CASE("what is kept beside a new point within the match distance lingers") {
  const Sequence sequence = [] {
    Sequence twice = tilted_box();
    twice.frames.push_back(twice.frames[0]);
    return twice;
  }();
  SequenceCollider subject = giving_points(Claims::manifold);
  subject.keeping = {.gap = {0.1}, .drift = {0.1}, .match = {0.1}, .points_max = 4};
  const auto first = corners_of(sequence);
  auto beside = first;
  for (const double aside : {0.05, 0.2}) {
    KeptPoint born = first[0];
    born.id = 7;
    born.born = 1;
    const Vector2<double> along = sequence.frames[0].b.rotation.cast<double>();
    born.anchor_b.x() += aside;
    born.anchor_a += aside * Vector2<double>(along.x(), 0);
    born.depth -= aside * along.y();
    for (const MatchBy by : {MatchBy::both, MatchBy::either, MatchBy::a, MatchBy::b}) {
      subject.keeping.match_by = by;
      const std::vector<KeptAnswer> answers{KeptManifold{first},
                                            KeptManifold{{first[0], first[1], born}}};
      const Bucket bucket = judge_sequence(sequence, subject, answers).bucket;
      CHECK(bucket.kind == (aside < 0.1 ? Kind::lingering : Kind::none));
      // In the old one's place it is right.
      born.id = first[0].id;
      const std::vector<KeptAnswer> replaced{KeptManifold{first}, KeptManifold{{born, first[1]}}};
      CHECK(judge_sequence(sequence, subject, replaced).bucket.kind != Kind::lingering);
      born.id = 7;
    }
  }
}

TEST_CASE("a match by one body's anchors asks for nothing where only the other's are near") {
  Sequence sequence = tilted_box();
  sequence.frames.push_back(sequence.frames[0]);
  sequence.frames[1].b.position.x() += 0.5F;  // slides: its corner is elsewhere on the floor
  SequenceCollider subject = giving_points(Claims::manifold);
  subject.keeping = {.gap = {0.1}, .drift = {1}, .match = {0.1}, .points_max = 4};
  const auto first = corners_of(sequence);
  KeptPoint born = first[0];
  born.id = 7;
  born.born = 1;
  born.anchor_a.x() += 0.5;
  const std::vector<KeptAnswer> answers{KeptManifold{first},
                                        KeptManifold{{first[0], first[1], born}}};
  for (const auto& [by, kind] :
       {std::pair{MatchBy::both, Kind::none}, std::pair{MatchBy::a, Kind::none},
        std::pair{MatchBy::b, Kind::lingering}, std::pair{MatchBy::either, Kind::lingering}}) {
    subject.keeping.match_by = by;
    CHECK(judge_sequence(sequence, subject, answers).bucket.kind == kind);
  }
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
