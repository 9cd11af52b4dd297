#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "known_by_hand.hpp"

// How wrong answers are whose errors are known by arithmetic of this test's own.

using namespace manifuzz;
using namespace manifuzz::known_by_hand;
using Catch::Matchers::WithinRel;

namespace {

/// A wrong answer: of this pair the right one, changed; wrong by so much, in this above all.
struct Planted {
  std::string name;
  PairCase pair;
  std::vector<Change> changes;
  Component component;
  double magnitude;
};

Manifold<double> changed(const Planted& planted) {
  Manifold<double> manifold = right_of(planted.pair);
  for (const Change& change : planted.changes) change(manifold);
  return manifold;
}

std::vector<Planted> two_errors() {
  const PairCase two = leaning();
  const PairCase one = standing_on_corner();
  const double s = kLeaning;
  const double c = kOnCorner;
  using C = Component;
  constexpr int kRight = 0;  // 0.06 deep
  constexpr int kLeft = 1;   // 0.1 deep
  return {
      {"side, far point", two, {wrong_side(), moved(kLeft, -100, 0)}, C::position, 100 / s},
      {"side, depth", two, {wrong_side(), deeper(kLeft, 50)}, C::depth, 50 / s},
      {"side, small depth", two, {wrong_side(), deeper(kRight, 0.01)}, C::depth, 0.01 / s},
      {"side, missing", two, {wrong_side(), without(kLeft)}, C::missing, 0.1 / s},
      {"side, turned", two, {wrong_side(), turned(1e-3)}, C::normal, 1e-3},
      {"feature, point", two, {wrong_feature(), moved(kRight, 0, -0.25)}, C::position, 0.25 / s},
      {"feature, depth", two, {wrong_feature(), deeper(kLeft, 0.25)}, C::depth, 0.25 / s},
      {"far point, depth", two, {moved(kLeft, -100, 0), deeper(kLeft, 50)}, C::position, 100 / s},
      {"point, depth", two, {moved(kLeft, -0.02, 0), deeper(kLeft, 0.5)}, C::depth, 0.5 / s},
      {"point, other depth",
       two,
       {moved(kLeft, -0.03, 0), deeper(kRight, 0.01)},
       C::position,
       0.03 / s},
      {"both points", two, {moved(kLeft, -3, 0), moved(kRight, 5, 0)}, C::position, 5 / s},
      {"both depths", two, {deeper(kLeft, 0.3), deeper(kRight, 0.7)}, C::depth, 0.7 / s},
      {"missing, other depth", two, {without(kLeft), deeper(0, 0.02)}, C::missing, 0.1 / s},
      {"missing, greater depth", two, {without(kRight), deeper(0, 0.2)}, C::depth, 0.2 / s},
      {"missing, far point", two, {without(kRight), moved(0, -9, 0)}, C::position, 9 / s},
      {"turned, depth", two, {turned(1e-3), deeper(kLeft, 0.04)}, C::depth, 0.04 / s},
      {"turned, small depth", two, {turned(1e-2), deeper(kLeft, 1e-3)}, C::normal, 1e-2},
      {"turned, point", two, {turned(1e-3), moved(kRight, 0, 0.02)}, C::position, 0.02 / s},
      {"turned, missing", two, {turned(1e-3), without(kRight)}, C::missing, 0.06 / s},
      {"one too many, deep", one, {with_another(0.1, 0.95, 0.05)}, C::extra, 0.05 / c},
      {"one too many, far", one, {with_another(0, 2.9, 0.05)}, C::extra, 1.9 / c},
      {"one too many, side",
       one,
       {wrong_side(), with_another(0.1, 0.95, 0.05)},
       C::extra,
       0.05 / c},
      {"one too many, depth",
       one,
       {with_another(0.1, 0.95, 0.02), deeper(0, 0.2)},
       C::depth,
       0.2 / c},
      {"one too many, point",
       one,
       {with_another(0.1, 0.95, 0.02), moved(0, 0, 0.06)},
       C::position,
       0.06 / c},
      {"one too many, turned", one, {with_another(0.1, 0.95, 0.01), turned(0.02)}, C::normal, 0.02},
  };
}

}  // namespace

TEST_CASE("no error of an answer hides another: the greater of two is how wrong it is") {
  const auto all = two_errors();
  CHECK(all.size() >= 20);
  for (const Planted& planted : all) {
    CAPTURE(planted.name);
    const Judgement judgement = judged(planted.pair, changed(planted));
    CHECK(judgement.bucket.verdict == Verdict::subject_wrong);
    CHECK(judgement.of_subject.component == planted.component);
    CHECK_THAT(judgement.magnitude, WithinRel(planted.magnitude, 2e-4));
    const bool is_gross = judgement.magnitude > 0.01;
    CHECK((judgement.bucket.error_class == ErrorClass::gross) == is_gross);
  }
}

TEST_CASE("one point that is far away leaves the other errors at none") {
  for (const double far : {0.5, 3.0, 10.0, 1e155, 1e300}) {
    CAPTURE(far);
    const Planted planted{"", leaning(), {moved(1, -far, 0)}, Component::position, far / kLeaning};
    const Judgement judgement = judged(planted.pair, changed(planted));
    Errors expected;
    expected[Component::position] = judgement.magnitude;
    CHECK(judgement.of_subject.errors == expected);
    CHECK_THAT(judgement.magnitude, WithinRel(planted.magnitude, 1e-4));
    CHECK(judgement.bucket.error_class == ErrorClass::gross);
  }
}

TEST_CASE("a normal beyond what squares hold is as wrong as it is long") {
  Manifold<double> manifold = right_of(leaning());
  manifold.normal *= 1e200;
  const Judgement judgement = judged(leaning(), manifold);
  CHECK(judgement.bucket.kind == Kind::normal);
  CHECK_THAT(judgement.magnitude, WithinRel(1e200, 1e-12));
}
