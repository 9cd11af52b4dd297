#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "report/upstream/effect.hpp"
#include "report/upstream/parts.hpp"
#include "unit/report/sample.hpp"

// What users see of an answer follows from its own figures: from the depth and the normal that were
// given, and those that are right.

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// What users see where a box of 1 by 1 lies below a box of 2 by 2, `overlap` deep in it, and Box2D
/// answers with two points of this depth along this normal.
std::string seen_of(float overlap, const Vector2<double>& normal, double depth, Kind kind) {
  JudgedCase judged = judged_case(box_on_box(overlap));
  Manifold<double> answer;
  answer.count = 2;
  answer.normal = normal;
  const double height = -1 + static_cast<double>(overlap);
  answer.points[0] = {{-0.5, height}, depth, {}};
  answer.points[1] = {{0.5, height}, depth, {}};
  judged.oracle.answer = answer;
  judged.judgement.bucket.kind = kind;
  return seen_by_users(judged, judged.oracle);
}

const Vector2<double> kDown(0, -1);
const Vector2<double> kUp(0, 1);
const Vector2<double> kAside(1, 0);

const std::string kTooLittle =
    "; that is too little to be visible on a shape of size 1.41, but exact comparisons fail";

/// A figure of ours, with three digits.
std::string digits(double value) {
  return fmt::format("{:.3g}", value);
}

}  // namespace

TEST_CASE("what is seen of a depth along the right normal") {
  // Kinds are the judge's; the sentence is the figures'.
  for (const Kind kind : {Kind::depth, Kind::inconsistent, Kind::normal, Kind::not_minimal}) {
    CHECK(seen_of(0.25F, kDown, 0, kind) ==
          "a depth of 0 pushes nothing apart: the bodies stay 0.25 inside each other, or move "
          "further in");
    CHECK(seen_of(0.25F, kDown, 0.125, kind) ==
          "the bodies are pushed by 0.125 where 0.25 is needed, and stay 0.125 inside each other");
    CHECK(seen_of(0.25F, kDown, 48000, kind) ==
          "the bodies are pushed by 4.8e+04 where 0.25 suffices");
    CHECK_THAT(seen_of(0.25F, kDown, 0.25 + 0x1p-16, kind),
               Contains("are pushed " + digits(0x1p-16) + " farther than they need" + kTooLittle));
    CHECK_THAT(seen_of(0.25F, kDown, 0.25 - 0x1p-16, kind),
               Contains("the bodies stay " + digits(0x1p-16) + " inside each other" + kTooLittle));
  }
}

TEST_CASE("what is seen of a depth along another normal") {
  // Aside the box of 1 leaves the box of 2 once it is moved by 1.5; below it by 0.25.
  CHECK(seen_of(0.25F, kAside, 0, Kind::not_minimal) ==
        "a depth of 0 pushes nothing apart: the bodies stay 0.25 inside each other, or move "
        "further in");
  CHECK(seen_of(0.25F, kAside, 1, Kind::not_minimal) ==
        "the bodies are pushed by 1 along a direction that is off by 90 degrees, and stay 0.25 "
        "inside each other");
  CHECK(seen_of(0.25F, kAside, 1.375, Kind::not_minimal) ==
        "the bodies are pushed by 1.38 along a direction that is off by 90 degrees, and stay "
        "0.125 inside each other");
  CHECK(seen_of(0.25F, kAside, 1.5, Kind::not_minimal) ==
        "the bodies are pushed by 1.5 where 0.25 suffices");
  CHECK(seen_of(0.25F, kAside, 100, Kind::normal) ==
        "the bodies are pushed by 100 where 0.25 suffices");
  CHECK(seen_of(0.25F, kUp, 0.25, Kind::reversed) ==
        "the bodies are pushed 0.25 further into each other");
  CHECK(seen_of(0.25F, kUp, 0, Kind::reversed) ==
        "a depth of 0 pushes nothing apart: the bodies stay 0.25 inside each other, or move "
        "further in");
  // 30 degrees off, and just as long as it takes along that direction: 0.25 / cos 30.
  const double angle = std::numbers::pi / 6;
  const Vector2<double> turned(std::sin(angle), -std::cos(angle));
  CHECK(seen_of(0.25F, turned, 0.25 / std::cos(angle), Kind::normal) ==
        "the bodies are pushed by " + digits(0.25 / std::cos(angle)) + " where 0.25 suffices");
  CHECK(seen_of(0.25F, turned, 0.25, Kind::normal) ==
        "the bodies are pushed by 0.25 along a direction that is off by 30 degrees, and stay " +
            digits(0.25 - 0.25 * std::cos(angle)) + " inside each other");
}

TEST_CASE("what is seen of a contact of bodies that just touch") {
  CHECK(seen_of(0, kUp, 0, Kind::reversed) ==
        "the normal points the wrong way, so impulses drive the bodies into each other");
  CHECK(seen_of(0, kUp, 0.5, Kind::reversed) ==
        "the bodies are pushed 0.5 further into each other");
  CHECK(seen_of(0, kDown, 0.5, Kind::depth) == "the bodies are pushed by 0.5 where 0 suffices");
  const double angle = std::numbers::pi / 6;
  CHECK(seen_of(0, {std::sin(angle), -std::cos(angle)}, 0, Kind::normal) ==
        "impulses act along a direction that is off by 30 degrees");
}

TEST_CASE("what is seen of a contact across a gap") {
  CHECK(seen_of(-0.5F, kDown, 0, Kind::phantom_contact) ==
        "bodies that are 0.5 apart are stopped as if they touched");
  CHECK(seen_of(-0.5F, kDown, 2, Kind::phantom_contact) ==
        "bodies that are 0.5 apart are pushed by 2, away from each other");
  CHECK(seen_of(-0.5F, kUp, 2, Kind::phantom_contact) ==
        "bodies that are 0.5 apart are pushed by 2, towards each other");
}

TEST_CASE("what is seen of a normal's length") {
  CHECK(seen_of(0.25F, {0, 0}, 0.25, Kind::normal) ==
        "a normal of length 0 has no direction to push along, so the bodies stay inside each "
        "other");
  CHECK(seen_of(0.25F, {0, -0.75}, 0.25, Kind::normal) ==
        "what takes the normal for one of length 1 pushes too little, by a factor of 0.75");
  CHECK(seen_of(0.25F, {0, -2}, 0.25, Kind::normal) ==
        "what takes the normal for one of length 1 pushes too far, by a factor of 2");
}

TEST_CASE("what is seen of no contact, and of contact points") {
  JudgedCase judged = judged_case(box_on_box(0.25F));
  judged.oracle.answer = Manifold<double>{};
  judged.judgement.bucket.kind = Kind::missed_contact;
  CHECK(seen_by_users(judged, judged.oracle) ==
        "nothing pushes the bodies apart: they stay 0.25 inside each other, or move further in");

  Manifold<double> answer;
  answer.count = 1;
  answer.normal = kDown;
  answer.points[0] = {{0.5, -0.75}, 0.25, {}};
  judged.oracle.answer = answer;
  judged.judgement.bucket.kind = Kind::count;
  CHECK(seen_by_users(judged, judged.oracle) ==
        "one contact point carries bodies that touch along 1, so they rock");
  answer.count = 2;
  answer.points[1] = {{0.25, -0.75}, 0.25, {}};
  judged.oracle.answer = answer;
  CHECK(seen_by_users(judged, judged.oracle) ==
        "the contact points are 0.25 apart where the bodies touch along 1, so they rock");

  judged.judgement.bucket.kind = Kind::position;
  answer.points[1] = {{-3.5, -0.75}, 0.25, {}};
  judged.oracle.answer = answer;
  CHECK(seen_by_users(judged, judged.oracle) ==
        "the impulse acts 3 beside the right place, so the bodies get a spin that they should not "
        "have");
  judged.judgement.bucket.kind = Kind::witness;
  CHECK(seen_by_users(judged, judged.oracle) ==
        "the impulse acts 3 outside one of the bodies, so the bodies get a spin that they should "
        "not have");
}

TEST_CASE("how deep bodies are in each other once they are pushed") {
  const PairCase boxes = box_on_box(0.25F);
  CHECK(overlap_once_pushed(boxes, {0, 0}) == Approx(0.25));
  CHECK(overlap_once_pushed(boxes, {0, -1}) == Approx(-0.75));
  CHECK(overlap_once_pushed(boxes, {0, 0.5}) == Approx(0.75));
  // Circles of radius 1 whose centres are 1 apart, pushed at a right angle: sqrt 2 apart.
  PairCase circles;
  const std::array<Vector2<float>, 1> centre{Vector2<float>(0, 0)};
  circles.a.polygon = circles.b.polygon = make_polygon<float>(centre, 1.0F);
  circles.b.pose.position = {1, 0};
  CHECK(overlap_once_pushed(circles, {0, 1}) == Approx(2 - std::sqrt(2)));
  CHECK(overlap_once_pushed(circles, {-1, 0}) == Approx(2));
}
