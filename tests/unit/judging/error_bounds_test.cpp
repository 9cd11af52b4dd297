#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "judging/errors/clip_error.hpp"
#include "known_by_hand.hpp"

// How wrong an answer is where only one thing is, or next to its bound.

using namespace manifuzz;
using namespace manifuzz::known_by_hand;
using Catch::Matchers::WithinRel;

TEST_CASE("a wrong side or feature alone is of kind features, and has no magnitude") {
  for (const Change& change : {wrong_side(), wrong_feature()}) {
    Manifold<double> manifold = right_of(leaning());
    change(manifold);
    const Judgement judgement = judged(leaning(), manifold);
    CHECK(judgement.bucket.verdict == Verdict::subject_wrong);
    CHECK(judgement.bucket.kind == Kind::features);
    CHECK(judgement.magnitude == 0);
    CHECK(judgement.of_subject.errors == Errors());
  }
}

TEST_CASE("another face is wrong by what it is deeper than the best, not by its direction") {
  const float by = 0.11F;
  const PairCase pair = boxes(by);
  // An equal overlap from the other side: in y, as if that were less.
  PairCase narrow = pair;
  narrow.b.pose.position.x() = 1.5F;
  Manifold<double> of_top = right_of(narrow);
  REQUIRE(of_top.normal.y() > 0.5);
  for (int i = 0; i < of_top.count; ++i) {  // to where the boxes overlap in `pair`
    ContactPoint<double>& point = of_top.points[i];
    if (point.position.x() < 1) point.position.x() = static_cast<double>(1.9F) - 1;
  }
  const Judgement judgement = judged(pair, of_top);
  const double in_x = 2 - static_cast<double>(1.9F);
  const double in_y = 2 - static_cast<double>(2 - by);
  CHECK(judgement.bucket.kind == Kind::not_minimal);
  CHECK_THAT(judgement.magnitude, WithinRel((in_y - in_x) / kOnCorner, 1e-6));
}

TEST_CASE("a contact across a gap is as wrong as what it claims, and one that is missed as deep") {
  PairCase apart = leaning();
  apart.b.pose.position = {0, 10.5F};
  Manifold<double> phantom = right_of(leaning());
  phantom.points[0].depth = 1000;
  const Judgement across = judged(apart, phantom);
  CHECK(across.bucket.kind == Kind::phantom_contact);
  CHECK(across.bucket.error_class == ErrorClass::gross);
  CHECK_THAT(across.magnitude, WithinRel(1000 / kLeaning, 1e-6));
  const Judgement missed = judged(leaning(), Manifold<double>{});
  CHECK(missed.bucket.kind == Kind::missed_contact);
  CHECK_THAT(missed.magnitude, WithinRel(0.1 / kLeaning, 1e-5));
  CHECK(missed.of_subject.component == Component::missing);
}

TEST_CASE("an error just above its bound is as large as the bound, whatever else is beside it") {
  const PairCase pair = leaning();
  const Admissible right = admissible(pair, declared());
  const exact::Clip& clip = *right.candidates.front();
  const double position = position_bound(right, clip, clip.points[0]);
  const double depth = depth_bound(right, clip, clip.points[0]);
  struct Edge {
    Component component;
    std::function<Change(double)> change;  ///< by so many bounds
    double bound;                          ///< as a share of the size
  };
  const std::vector<Edge> edges{
      {Component::position, [&](double n) { return moved(0, n * position, 0); },
       position / kLeaning},
      {Component::depth, [&](double n) { return deeper(0, n * depth); }, depth / kLeaning},
      {Component::normal, [&](double n) { return turned(n * right.bounds.normal); },
       right.bounds.normal}};
  for (const Edge& edge : edges) {
    CAPTURE(kComponentNames[static_cast<std::size_t>(edge.component)]);
    Manifold<double> below = right_of(pair);
    edge.change(0.5)(below);
    CHECK(judged(pair, below).bucket.fault == Fault::none);
    Manifold<double> above = right_of(pair);
    edge.change(1.6)(above);
    const Judgement alone = judged(pair, above);
    CHECK(alone.of_subject.component == edge.component);
    CHECK(alone.magnitude >= edge.bound);
    CHECK(alone.magnitude <= 2.2 * edge.bound);
    CHECK(alone.bucket.error_class == ErrorClass::rounding);
    for (Manifold<double> beside : {below, above}) {
      deeper(1, 0.25)(beside);
      CHECK_THAT(judged(pair, beside).magnitude, WithinRel(0.25 / kLeaning, 1e-3));
    }
  }
}

TEST_CASE(
    "a point that is missing, or too many, or of a deeper face, by little is wrong by little") {
  // One point barely deeper than its bound is left out.
  PairCase shallow = leaning();
  shallow.b.polygon = polygon({{-0.5F, 0}, {0.5F, 0.1F}, {0, 1}});
  const double rise = static_cast<double>(0.1F);
  shallow.b.pose.position = {0, 0.9F + 1e-6F};
  const double shallower = 1 - static_cast<double>(0.9F + 1e-6F) - rise;
  const double deep = 1 - static_cast<double>(0.9F + 1e-6F);
  Manifold<double> manifold = right_of(shallow);
  if (shallower > 0) {
    const int second = manifold.points[0].depth < manifold.points[1].depth ? 0 : 1;
    without(second)(manifold);
    const Judgement judgement = judged(shallow, manifold);
    if (judgement.bucket.fault != Fault::none) {
      CHECK(judgement.magnitude <= 1.1 * shallower / size(shallow));
    }
  } else {
    // It is no point at all then: reported with no depth it is one too many, by no more.
    REQUIRE(manifold.count == 1);
    with_another(0.5, 1 - deep + rise, 0)(manifold);
    CHECK(judged(shallow, manifold).magnitude <= 1e-5);
  }
  // The faces' separations differ by two ulps.
  const PairCase near = boxes(std::nextafter(std::nextafter(0.1F, 1.0F), 1.0F));
  CHECK(judged(near, right_of(near)).magnitude <= 1e-6);
}

TEST_CASE("an answer that the curve judges has every error too") {
  PairCase pair = leaning();
  pair.b.polygon = make_polygon<float>(std::vector<Vector2<float>>{{0, 0}}, 0.5F);
  pair.b.pose.position = {0, 1.4F};
  Declaration declaration = declared();
  declaration.clips = false;
  const Manifold<double> right = right_of(pair);
  REQUIRE(judged(pair, right, declaration).bucket.fault == Fault::none);
  Manifold<double> far = right;
  far.points[0].position += Vector2<double>(2, 0);  // two sizes: a circle of radius 0.5 is 1 across
  const Judgement witness = judged(pair, far, declaration);
  CHECK(witness.bucket.kind == Kind::witness);
  CHECK(witness.bucket.error_class == ErrorClass::gross);
  CHECK_THAT(witness.magnitude, WithinRel(2.0, 0.01));
  far.points[0].depth += 0.25;
  const Judgement both = judged(pair, far, declaration);
  CHECK(both.bucket.kind == Kind::inconsistent);
  CHECK_THAT(both.magnitude, WithinRel(2.0, 0.01));
  CHECK_THAT(both.of_subject.errors[Component::depth], WithinRel(0.25, 0.01));
  Manifold<double> reversed = right;
  reversed.normal = -reversed.normal;
  CHECK(judged(pair, reversed, declaration).bucket.kind == Kind::reversed);
  CHECK(judged(pair, reversed, declaration).magnitude == 2);
}

TEST_CASE("what rounding hides is ill posed as far as the bound goes, and wrong beyond") {
  // A box of half-width 100,000 below a small one: the bound of floats is a twentieth of that.
  PairCase pair;
  pair.a.polygon = polygon({{-1e5F, -1e5F}, {1e5F, -1e5F}, {1e5F, 1e5F}, {-1e5F, 1e5F}});
  pair.b.polygon = polygon({{-0.5F, -0.5F}, {0.5F, -0.5F}, {0.5F, 0.5F}, {-0.5F, 0.5F}});
  const Declaration of_floats = make_clip().declaration;
  const auto verdict_at = [&](float gap) {
    pair.b.pose.position = {0, 1e5F + 0.5F + gap};
    PairCase touching = pair;
    touching.b.pose.position = {0, 1e5F + 0.4375F};
    return judged(pair, right_of(touching), of_floats).bucket.verdict;
  };
  CHECK(verdict_at(0.0625F) == Verdict::ill_posed);
  CHECK(verdict_at(9.5F) == Verdict::subject_wrong);
}
