#include "judging/extent.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "judging/by_curve.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;

namespace {

/// As clip64 answers, but that nothing is said of a clip.
Declaration promising() {
  Declaration declaration = make_clip64().declaration;
  declaration.clips = false;
  return declaration;
}

/// Cases of polygons with two points that floats, too, would give, and clearly so.
template <class Check>
void for_two_points(const Check& check) {
  for (const Regime& regime : polygon_regimes()) {
    for (std::uint64_t i = 0; i < 60; ++i) {
      const PairCase pair = generate(5, regime, i);
      const auto truth = std::make_shared<const exact::Truth>(pair);
      const Admissible wide = admissible(truth, make_clip().declaration);
      if (wide.candidates.size() != 1 || !wide.must_touch) continue;
      const auto right = std::get<Manifold<double>>(make_clip64().collide(pair));
      if (right.count < 2 || compare_apart(*wide.candidates[0], 40 * wide.bounds.position) <= 0) {
        continue;
      }
      if (std::min(right.points[0].depth, right.points[1].depth) < 4 * wide.bounds.separation) {
        continue;
      }
      std::string line;
      append_case_line(line, pair);
      INFO(regime.name << ", index " << i << "\n" << line);
      check(*truth, right);
    }
  }
}

int deepest_of(const Manifold<double>& manifold) {
  return manifold.points[1].depth > manifold.points[0].depth ? 1 : 0;
}

Manifold<double> deepest_alone(Manifold<double> manifold) {
  manifold.points[0] = manifold.points[deepest_of(manifold)];
  manifold.count = 1;
  return manifold;
}

/// The shallower point a part of the way to the deeper one, on the same edge.
Manifold<double> shortened(Manifold<double> manifold, double by) {
  const ContactPoint<double>& deepest = manifold.points[deepest_of(manifold)];
  ContactPoint<double>& other = manifold.points[1 - deepest_of(manifold)];
  other.position += by * (deepest.position - other.position);
  other.depth += by * (deepest.depth - other.depth);
  return manifold;
}

ExtentLeftOut left_out(const exact::Truth& truth, const Manifold<double>& manifold) {
  const Declaration declaration = promising();
  return extent_left_out(truth, declaration.tie_bias,
                         bounds(truth.pair(), declaration, truth.extent()), manifold);
}

}  // namespace

TEST_CASE("a clip's own points leave nothing of its extent out") {
  int cases = 0;
  for_two_points([&](const exact::Truth& truth, const Manifold<double>& right) {
    ++cases;
    const ExtentLeftOut left = left_out(truth, right);
    REQUIRE(left.points == 0);
    REQUIRE(left.share() == 0.0);
    REQUIRE(judge_by_curve(truth, promising(), right).kind == Kind::none);
  });
  CHECK(cases > 200);
}

TEST_CASE("one point of two leaves all out, which is wrong where two are promised") {
  Declaration one_is_enough = promising();
  one_is_enough.one_point_enough = true;
  for_two_points([&](const exact::Truth& truth, const Manifold<double>& right) {
    const Manifold<double> one = deepest_alone(right);
    const ExtentLeftOut left = left_out(truth, one);
    REQUIRE(left.points == 1);
    REQUIRE(left.share() == 1.0);
    REQUIRE(judge_by_curve(truth, promising(), one).kind == Kind::count);
    REQUIRE(judge_by_curve(truth, one_is_enough, one).kind == Kind::none);
  });
}

TEST_CASE("the share of the extent that two points leave out is measured, and judged") {
  Declaration one_is_enough = promising();
  one_is_enough.one_point_enough = true;
  for_two_points([&](const exact::Truth& truth, const Manifold<double>& right) {
    const Manifold<double> shorter = shortened(right, 0.25);
    const ExtentLeftOut left = left_out(truth, shorter);
    REQUIRE(left.points == 0);
    REQUIRE(*left.share() == Approx(0.25));
    REQUIRE(judge_by_curve(truth, promising(), shorter).kind == Kind::extent);
    REQUIRE(judge_by_curve(truth, one_is_enough, shorter).kind == Kind::none);
  });
}

TEST_CASE("nothing of a contact of one point is left out") {
  // A square on edge, its corner in the middle of a face.
  PairCase pair;
  const std::array<Vector2<float>, 4> corners{Vector2<float>{-1, -1}, Vector2<float>{1, -1},
                                              Vector2<float>{1, 1}, Vector2<float>{-1, 1}};
  pair.a.polygon = make_polygon<float>(corners);
  pair.b.polygon = make_polygon<float>(corners);
  pair.b.pose = {{0, 2}, {0.6F, 0.8F}};
  const exact::Truth truth(pair);
  const auto right = std::get<Manifold<double>>(make_clip64().collide(pair));
  const ExtentLeftOut left = left_out(truth, deepest_alone(right));
  CHECK(left.points == 0);
  CHECK_FALSE(left.share().has_value());
}
