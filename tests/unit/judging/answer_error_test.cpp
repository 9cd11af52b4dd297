#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "judging/errors/clip_error.hpp"
#include "judging/judge.hpp"
#include "own_colliders/own_colliders.hpp"

// How wrong answers are whose errors are known by arithmetic of this test's own.

using namespace manifuzz;
using Catch::Matchers::WithinRel;

namespace {

ConvexPolygon<float> polygon(const std::vector<Vector2<float>>& corners) {
  return make_polygon<float>(corners, 0);
}

/// A box of half-width 1 and on its top face a triangle whose lower edge rises by 0.04: the right
/// points are 0.1 and 0.06 deep, at x = -0.5 and 0.5, and the triangle is sqrt(1.25) across.
PairCase leaning() {
  PairCase pair;
  pair.a.polygon = polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  pair.b.polygon = polygon({{-0.5F, 0}, {0.5F, 0.04F}, {0, 1}});
  pair.b.pose.position = {0, 0.9F};
  return pair;
}
const double kLeaning = std::sqrt(1.25);

/// The triangle stands on its corner: one right point, (0, 0.9), 0.1 deep; it is sqrt(16.25)
/// across, the box sqrt(8).
PairCase standing_on_corner() {
  PairCase pair = leaning();
  pair.b.polygon = polygon({{0, 0}, {2, 0.5F}, {-2, 1}});
  return pair;
}
const double kOnCorner = std::sqrt(8.0);

/// Boxes that overlap by 0.1 in x and by `by` in y.
PairCase boxes(float by) {
  PairCase pair;
  pair.a.polygon = polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  pair.b.polygon = pair.a.polygon;
  pair.b.pose.position = {1.9F, 2 - by};
  return pair;
}

Manifold<double> right_of(const PairCase& pair) {
  return std::get<Manifold<double>>(make_clip64().collide(pair));
}

Declaration declared() {
  return make_clip64().declaration;
}

Judgement judged(const PairCase& pair, const Answer& answer,
                 const Declaration& declaration = declared()) {
  const Collider oracle = make_clip64();
  const Answer of_oracle = oracle.collide(pair);
  return judge(pair, {declaration, answer}, {oracle.declaration, of_oracle});
}

using Change = std::function<void(Manifold<double>&)>;

Change wrong_side() {
  return [](Manifold<double>& m) { m.reference = other(m.reference); };
}
Change wrong_feature() {
  return [](Manifold<double>& m) { m.points[0].features.a.index ^= 1; };
}
Change moved(int point, double x, double y) {
  return [=](Manifold<double>& m) { m.points[point].position += Vector2<double>(x, y); };
}
Change deeper(int point, double by) {
  return [=](Manifold<double>& m) { m.points[point].depth += by; };
}
Change turned(double by) {
  return [=](Manifold<double>& m) {
    m.normal = Vector2<double>(m.normal.x() + by, m.normal.y()).normalized();
  };
}
Change without(int point) {
  return [=](Manifold<double>& m) {
    m.points[0] = m.points[1 - point];
    m.count = 1;
  };
}
Change with_another(double x, double y, double depth) {
  return [=](Manifold<double>& m) {
    m.points[1] = m.points[0];
    m.points[1].position = {x, y};
    m.points[1].depth = depth;
    m.count = 2;
  };
}

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
      {"feature, point", two, {wrong_feature(), moved(kRight, 0, 0.25)}, C::position, 0.25 / s},
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
       {wrong_side(), with_another(0.1, 0.95, 0.15)},
       C::extra,
       0.15 / c},
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
    // Of a large error what other faces are deeper may be taken off: here 3 at most.
    CHECK(judgement.magnitude <= 1.0001 * planted.magnitude);
    CHECK(judgement.magnitude >= 0.9 * planted.magnitude);
    const bool is_gross = judgement.magnitude > 0.01;
    CHECK((judgement.bucket.error_class == ErrorClass::gross) == is_gross);
  }
}

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
  // The same overlap from the other side: in y, as if that were less.
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
