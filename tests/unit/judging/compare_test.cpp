#include "judging/compare.hpp"

#include <limits>
#include <string_view>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "generating/regime.hpp"
#include "judging/judge.hpp"
#include "judging/unjudged.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// Two boxes 2 across, B half a unit into the upper face of A and to the right.
PairCase boxes() {
  const Vector2<float> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  PairCase pair{{make_polygon<float>(corners), {}}, {make_polygon<float>(corners), {}}};
  pair.b.pose.position = {0.25F, 1.5F};
  return pair;
}

Manifold<double> contact(const PairCase& pair) {
  return std::get<Manifold<double>>(make_clip().collide(pair));
}

}  // namespace

TEST_CASE("what plainly agrees, the judge finds to agree") {
  const Collider subject = make_clip();
  const Collider oracle = make_clip64();
  for (const Regime& regime : regimes()) {
    CAPTURE(regime.name);
    int plain = 0;
    int others = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const PairCase pair = generate(5, regime, i);
      const Answer of_subject = subject.collide(pair);
      const Answer of_oracle = oracle.collide(pair);
      const ColliderAnswer s{subject.declaration, of_subject};
      const ColliderAnswer o{oracle.declaration, of_oracle};
      if (!plainly_agree(exact::Truth(pair), s, o)) continue;
      ++plain;
      others += judge(pair, s, o).bucket.verdict == Verdict::agree ? 0 : 1;
    }
    CHECK(others == 0);
    if (regime.name == "generic" || regime.name == "separated") CHECK(plain >= 900);
  }
}

TEST_CASE("what differs by more than both bounds does not plainly agree") {
  const PairCase pair = boxes();
  const exact::Truth truth(pair);
  const Declaration declaration = make_clip().declaration;
  const Bounds within = bounds(pair, declaration);
  const Manifold<double> right = contact(pair);
  REQUIRE(right.count == 2);
  const auto agrees = [&](const Manifold<double>& other) {
    const Answer s(right);
    const Answer o(other);
    return plainly_agree(truth, {declaration, s}, {declaration, o});
  };
  CHECK(agrees(right));
  Manifold<double> other = right;
  other.points[1].depth += 2.1 * within.separation;
  CHECK_FALSE(agrees(other));
  other = right;
  other.points[0].position.x() += 2.1 * within.position;
  CHECK_FALSE(agrees(other));
  other = right;
  other.normal.x() += 2.1 * within.normal;
  CHECK_FALSE(agrees(other));
  other = right;
  other.points[0].features.a.index ^= 1;
  CHECK_FALSE(agrees(other));
  other = right;
  other.count = 1;
  CHECK_FALSE(agrees(other));
  CHECK_FALSE(agrees({}));
}

TEST_CASE("nonsense is told from a manifold") {
  const PairCase pair = boxes();
  const Manifold<double> right = contact(pair);
  CHECK_FALSE(why_malformed(pair, right));
  CHECK_FALSE(why_malformed(pair, Manifold<double>()));
  const auto why_with = [&](const auto& change) {
    Manifold<double> changed = right;
    change(changed);
    return why_malformed(pair, changed).value_or("");
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr std::string_view finite = "is not finite; smaller coordinates are expected";
  CHECK(why_with([](auto& m) { m.count = 3; }) == "3 points; 0 to 2 are expected");
  CHECK(why_with([](auto& m) { m.count = -1; }) == "-1 points; 0 to 2 are expected");
  CHECK(why_with([&](auto& m) {
          m.normal = {nan, 0};
        }) == fmt::format("normal (nan, 0) {}", finite));
  CHECK(why_with([&](auto& m) {
          m.points[0].position = {0, nan};
        }) == fmt::format("point 0: position (0, nan) {}", finite));
  CHECK(why_with([&](auto& m) { m.points[1].depth = nan; }) ==
        fmt::format("point 1: depth nan {}", finite));
  CHECK(why_with([](auto& m) { m.points[1].depth = -1e-30; }) ==
        "point 1: depth -1e-30 is below 0; 0 or more is expected");
  CHECK(why_with([](auto& m) {
          m.points[1].features.b = {Feature::Kind::face, 4};
        }) == "point 1: names face 4 of B, which has 4");
}

TEST_CASE("two right manifolds differ in kind, and by their largest distance") {
  const PairCase pair = boxes();
  const Manifold<double> subject = contact(pair);
  CHECK(difference({}, subject, 0.5).kind == Kind::missed_contact);
  CHECK(difference(subject, {}, 0.5).kind == Kind::phantom_contact);
  CHECK(difference(subject, {}, 0.5).magnitude == 0.5);
  Manifold<double> other = subject;
  other.points[0].depth += 0.25;
  CHECK(difference(subject, other, 0).kind == Kind::position);
  CHECK(difference(subject, other, 0).magnitude == 0.25);
  other.points[1].position.x() += 0.5;
  CHECK(difference(subject, other, 0).magnitude == 0.5);
  other.count = 1;
  CHECK(difference(subject, other, 0).kind == Kind::count);
  other.reference = manifuzz::other(other.reference);
  CHECK(difference(subject, other, 0).kind == Kind::normal);
}

}  // namespace manifuzz
