#include <limits>

#include <catch2/catch.hpp>

#include "judging/judge.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;
using Catch::Matchers::WithinAbs;

namespace {

ConvexPolygon<float> box(float w, float h, float radius = 0) {
  const std::vector<Vector2<float>> corners{{-w, -h}, {w, -h}, {w, h}, {-w, h}};
  return make_polygon<float>(corners, radius);
}

PairCase boxes_at(float x, float y) {
  PairCase pair;
  pair.a.polygon = box(1, 1);
  pair.b.polygon = box(1, 1);
  pair.b.pose.position = {x, y};
  return pair;
}

Manifold<double> clip_of(const PairCase& pair) {
  return std::get<Manifold<double>>(make_clip().collide(pair));
}

Kind kind_of(const PairCase& pair, const Manifold<double>& manifold) {
  return mismatch(manifold, admissible(pair, make_clip().declaration)).kind;
}

Bucket bucket_of(const PairCase& pair, const Collider& subject, const Collider& oracle) {
  return judge(pair, subject, oracle).bucket;
}

Collider answering(const Manifold<double>& manifold) {
  Collider collider = make_clip();
  collider.collide = [manifold](const PairCase&) { return Answer(manifold); };
  return collider;
}

}  // namespace

TEST_CASE("the truth of two boxes") {
  const Admissible right = admissible(boxes_at(1.5F, 0.25F), make_clip().declaration);
  CHECK(leading(right.truth->fine_separation(right.truth->greatest())) == -0.5);
  CHECK(right.must_touch);
  REQUIRE(right.candidates.size() == 2);  // A's right face and B's left one, equally separated
  CHECK(right.candidates[0]->reference.side == Side::a);
  CHECK(right.candidates[0]->reference.index == 1);
  CHECK(right.candidates[0]->incident == 3);
  CHECK(right.candidates[1]->reference.side == Side::b);
}

TEST_CASE("a tie bias leaves A's face alone") {
  const Admissible right = admissible(boxes_at(1.5F, 0.25F), make_box2d().declaration);
  REQUIRE(right.candidates.size() == 1);
  CHECK(right.candidates[0]->reference.side == Side::a);
}

TEST_CASE("each way of being wrong has its kind") {
  const PairCase pair = boxes_at(1.5F, 0.25F);
  const Manifold<double> right = clip_of(pair);
  REQUIRE(kind_of(pair, right) == Kind::none);

  Manifold<double> wrong = right;
  wrong.count = 0;
  CHECK(kind_of(pair, wrong) == Kind::missed_contact);
  wrong = right;
  wrong.normal = {0.6, 0.8};
  CHECK(kind_of(pair, wrong) == Kind::normal);
  wrong = right;
  wrong.points[0].position.y() += 1e-4;
  CHECK(kind_of(pair, wrong) == Kind::position);
  wrong = right;
  wrong.points[1].depth += 1e-4;
  CHECK(kind_of(pair, wrong) == Kind::depth);
  wrong = right;
  wrong.count = 1;
  CHECK(kind_of(pair, wrong) == Kind::count);
  CHECK(kind_of(boxes_at(2.5F, 0.25F), right) == Kind::phantom_contact);
  CHECK(kind_of(boxes_at(2.5F, 0.25F), {}) == Kind::none);
}

TEST_CASE("a figure that is not finite is wrong in its own kind") {
  const PairCase pair = boxes_at(1.5F, 0.25F);
  const Manifold<double> right = clip_of(pair);
  for (const double figure :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Manifold<double> wrong = right;
    wrong.normal.x() = figure;
    CHECK(kind_of(pair, wrong) == Kind::normal);
    wrong = right;
    wrong.points[0].position.y() = figure;
    CHECK(kind_of(pair, wrong) == Kind::position);
    wrong = right;
    wrong.points[1].depth = figure;
    CHECK(kind_of(pair, wrong) == Kind::depth);
  }
}

TEST_CASE("features count where nothing that decides them is within bound") {
  PairCase pair = boxes_at(1.5F, 0.25F);
  pair.b.pose.rotation = {0.8F, 0.6F};  // one reference, one incident edge
  Manifold<double> wrong = clip_of(pair);
  REQUIRE(kind_of(pair, wrong) == Kind::none);
  REQUIRE(admissible(pair, make_clip().declaration).candidates.size() == 1);
  wrong.points[0].features.b.index ^= 1U;
  CHECK(kind_of(pair, wrong) == Kind::features);
}

TEST_CASE("what is right holds no empty manifold of polygons that overlap") {
  const auto rights_at = [](float x) {
    return right_manifolds(admissible(boxes_at(x, 0.25F), make_clip().declaration));
  };
  const auto overlapping = rights_at(1.5F);
  REQUIRE(overlapping.size() == 2);
  for (const Manifold<double>& manifold : overlapping) CHECK(manifold.count == 2);
  CHECK(rights_at(2).front().count == 0);
  CHECK(rights_at(2).back().count == 2);
  REQUIRE(rights_at(3).size() == 1);
  CHECK(rights_at(3).front().count == 0);
  // The slab of one of the faces that tie in float misses the deepest vertex.
  const std::vector<Vector2<float>> sliver{{0, 0}, {0, 2000}, {-2e-4F, 1000}};
  const std::vector<Vector2<float>> triangle{{100, 700}, {-200, 40}, {200, 0}};
  const PairCase tied{{make_polygon<float>(sliver), {}}, {make_polygon<float>(triangle), {}}};
  for (const auto& manifold : right_manifolds(admissible(tied, make_clip().declaration))) {
    CHECK(manifold.count > 0);
  }
}

TEST_CASE("errors within the bound are right, beyond it wrong") {
  const PairCase pair = boxes_at(1.5F, 0.25F);
  const Bounds within = bounds(pair, make_clip().declaration);
  Manifold<double> manifold = clip_of(pair);
  manifold.points[0].depth += 0.9 * within.separation;
  CHECK(kind_of(pair, manifold) == Kind::none);
  manifold.points[0].depth += 2.2 * within.separation;
  CHECK(kind_of(pair, manifold) != Kind::none);
}

TEST_CASE("touching within the bound may be reported or not") {
  const PairCase pair = boxes_at(2, 0.25F);
  CHECK(kind_of(pair, clip_of(pair)) == Kind::none);
  CHECK(kind_of(pair, {}) == Kind::none);
}

TEST_CASE("verdicts and whose fault it is") {
  const PairCase pair = boxes_at(1.5F, 0.25F);
  const Collider clip = make_clip();
  const Collider box2d = make_box2d();
  Manifold<double> wrong = clip_of(pair);
  wrong.points[0].depth += 0.25;
  const Collider liar = answering(wrong);

  CHECK(bucket_of(pair, clip, box2d).verdict == Verdict::agree);
  const Bucket of_subject = bucket_of(pair, liar, box2d);
  CHECK(of_subject.verdict == Verdict::subject_wrong);
  CHECK(of_subject.fault == Fault::subject);
  CHECK(of_subject.kind == Kind::depth);
  CHECK(bucket_of(pair, clip, liar).verdict == Verdict::oracle_wrong);
  CHECK(bucket_of(pair, liar, liar).verdict == Verdict::both_wrong);
  CHECK_THAT(judge(pair, liar, box2d).magnitude, WithinAbs(0.25 / std::sqrt(8.0), 1e-7));
}

TEST_CASE("a tie: both are right and differ") {
  const Bucket bucket = bucket_of(boxes_at(2, 0.25F), make_clip(), answering({}));
  CHECK(bucket.verdict == Verdict::tie);
  CHECK(bucket.fault == Fault::none);
  CHECK(bucket.kind == Kind::phantom_contact);
}

TEST_CASE("far from the origin, float in world coordinates cannot say") {
  PairCase pair = boxes_at(1.5F, 0.25F);
  for (const Side side : {Side::a, Side::b}) pair[side].pose.position.x() += 0x1p20F;
  CHECK(bucket_of(pair, make_clip(), make_clip64()).verdict == Verdict::agree);
  CHECK(bucket_of(pair, make_clip(), make_box2d()).verdict == Verdict::ill_posed);
}

TEST_CASE("an unsupported case and a malformed answer are verdicts of their own") {
  const PairCase pair = boxes_at(1.5F, 0.25F);
  Collider unable = make_clip();
  unable.collide = [](const PairCase&) { return Answer(Unsupported{"triangles only"}); };
  CHECK(bucket_of(pair, unable, make_box2d()).verdict == Verdict::unsupported);
  Manifold<double> nonsense = clip_of(pair);
  nonsense.points[0].features.b.index = 200;
  CHECK(bucket_of(pair, answering(nonsense), make_box2d()).verdict == Verdict::malformed);
  CHECK(bucket_of(pair, make_clip(), answering(nonsense)).fault == Fault::oracle);
}

TEST_CASE("a double collider of angles may take a face's normal from scaled vertices, no other") {
  PairCase pair = boxes_at(1.99F, 0);
  const std::vector<Vector2<float>> corners{{-1, -1}, {1, -0.0005F}, {1, 0.0005F}, {-1, 1}};
  pair.a.polygon = make_polygon<float>(corners, 0);
  Declaration declaration = make_clip64().declaration;
  Manifold<double> manifold = std::get<Manifold<double>>(make_clip64().collide(pair));
  REQUIRE(manifold.reference == Side::a);
  const auto kind_at = [&](double turn, bool takes_angles) {
    declaration.takes_angles = takes_angles;
    manifold.normal = {1, turn};
    return mismatch(manifold, admissible(pair, declaration)).kind;
  };
  // Two vertices, a roundoff off each, at 1 from the origin, over a face of 0.001.
  const double scaled = std::numeric_limits<double>::epsilon() / 2 * 2 / 0.001;
  CHECK(kind_at(0.9 * scaled, true) == Kind::none);
  CHECK(kind_at(1.1 * scaled, true) == Kind::normal);
  CHECK(kind_at(0.9 * scaled, false) == Kind::normal);
}
