#include "judging/by_curve.hpp"

#include <array>
#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;

namespace {

constexpr std::uint64_t kCases = 150;  // of each regime

/// The pairs of all regimes of polygons that overlap by clearly more than rounding.
template <class Check>
void for_overlapping(const Check& check) {
  for (const Regime& regime : polygon_regimes()) {
    for (std::uint64_t i = 0; i < kCases; ++i) {
      const PairCase pair = generate(19, regime, i, {.corpus = {}, .radius = 0});
      const exact::Truth truth(pair);
      const Declaration declaration = make_clip().declaration;
      const Bounds bound = bounds(pair, declaration, truth.extent());
      if (is_ill_posed(truth.size(), bound)) continue;
      if (truth.separation() > -20 * bound.separation) continue;
      std::string line;
      append_case_line(line, pair);
      INFO(regime.name << ", index " << i << "\n" << line);
      check(truth, bound);
    }
  }
}

Declaration without_clips(Declaration declaration) {
  declaration.clips = false;
  return declaration;
}

Declaration separating(ScalarType scalar) {
  Declaration declaration;
  declaration.scalar = scalar;
  declaration.claims = Claims::separation;
  return declaration;
}

/// A box whose top is at 0, and in it a wedge, 0.03 wide, that stands on its short edge, 11 below
/// the top; its tip is 1 below.
PairCase wedge_in_box() {
  const std::array<Vector2<float>, 4> box{{{-20, -40}, {20, -40}, {20, 0}, {-20, 0}}};
  const std::array<Vector2<float>, 3> wedge{{{-0.015F, -11}, {0.015F, -11}, {0, -1}}};
  return {{make_polygon<float>(box, 0.0F), {}}, {make_polygon<float>(wedge, 0.0F), {}}};
}

/// The wedge's corner that is deepest, and its tip.
Manifold<double> corner_and_tip() {
  Manifold<double> manifold;
  manifold.normal = {0, 1};
  manifold.count = 2;
  manifold.points[0] = {.position = {-0.015F, -11}, .depth = 11, .features = {}};
  manifold.points[1] = {.position = {0, -1}, .depth = 1, .features = {}};
  return manifold;
}

Penetration least_penetration(const exact::Truth& truth) {
  const exact::PenetrationCurve curve(truth, exact::Skin::mitred);
  return {true, curve.minima(0).front(), curve.least()};
}

Kind kind_of(const exact::Truth& truth, const Declaration& declaration, const Answer& answer) {
  return judge_by_curve(truth, declaration, answer).kind;
}

Manifold<double> clipped(const PairCase& pair, const Collider& collider) {
  return std::get<Manifold<double>>(collider.collide(pair));
}

}  // namespace

TEST_CASE("the least depth along its normal is right, to the last digit of double") {
  for_overlapping([](const exact::Truth& truth, const Bounds&) {
    const CurveJudgement judged =
        judge_by_curve(truth, separating(ScalarType::float64), least_penetration(truth));
    REQUIRE(judged.kind == Kind::none);
    REQUIRE(judged.consistent == true);
    REQUIRE(judged.minimal == true);
    REQUIRE(!judged.witness.has_value());
  });
}

TEST_CASE("a reversed normal is reversed, by a clip too") {
  for_overlapping([](const exact::Truth& truth, const Bounds&) {
    Penetration reversed = least_penetration(truth);
    reversed.normal = Vector2<double>(-reversed.normal.value());
    REQUIRE(kind_of(truth, separating(ScalarType::float32), reversed) == Kind::reversed);
    Manifold<double> manifold = clipped(truth.pair(), make_clip64());
    manifold.normal = -manifold.normal;
    const Declaration declaration = make_clip64().declaration;
    const Answer answer = manifold;
    REQUIRE(is_reversed(truth, {declaration, answer}));
  });
}

TEST_CASE("a deepest point that is a vertex is one to a collider that says so") {
  int vertices = 0;
  for_overlapping([&](const exact::Truth& truth, const Bounds&) {
    Declaration declaration = without_clips(make_clip64().declaration);
    declaration.points = PointsAt::vertex;
    declaration.claims = Claims::point;
    Manifold<double> manifold = clipped(truth.pair(), make_clip64());
    if (manifold.points[1].depth > manifold.points[0].depth) {
      std::swap(manifold.points[0], manifold.points[1]);
    }
    manifold.count = 1;
    const FeaturePair& features = manifold.points[0].features;
    const Feature& incident = manifold.reference == Side::a ? features.b : features.a;
    if (incident.kind != Feature::Kind::vertex) return;
    ++vertices;
    REQUIRE(kind_of(truth, declaration, manifold) == Kind::none);
  });
  CHECK(vertices > 500);
}

TEST_CASE("a point that is off the surface by ten bounds is no witness") {
  for_overlapping([](const exact::Truth& truth, const Bounds&) {
    const Declaration declaration = without_clips(make_clip64().declaration);
    const CurveBounds bound = curve_bounds(truth.pair(), declaration, truth.extent());
    const Manifold<double> right = clipped(truth.pair(), make_clip64());
    for (const double off : {-10.0, 10.0}) {
      Manifold<double> moved = right;
      moved.points[0].position += off * bound.across * moved.normal;
      const CurveJudgement judged = judge_by_curve(truth, declaration, moved);
      // Where the surface is steep, or the overlap thin, another line has such a point.
      if (judged.kind == Kind::none) continue;
      REQUIRE(judged.kind == Kind::witness);
      REQUIRE(judged.witness == false);
    }
  });
}

TEST_CASE("what turned faces or a tolerance allow makes no core narrower than rounding") {
  const exact::Truth truth(wedge_in_box());
  Declaration turned = without_clips(make_clip().declaration);
  turned.frame = RoundingFrame::world;
  turned.normals = NormalsFrom::world_vertices;
  CHECK(kind_of(truth, turned, corner_and_tip()) == Kind::witness);
  Declaration tolerant = without_clips(make_clip64().declaration);
  tolerant.tolerance.absolute = 0.41;
  CHECK(kind_of(truth, tolerant, corner_and_tip()) == Kind::witness);
  Manifold<double> corners = corner_and_tip();
  corners.points[1] = {.position = {0.015F, -11}, .depth = 11, .features = {}};
  CHECK(kind_of(truth, turned, corners) == Kind::none);
  CHECK(kind_of(truth, tolerant, corners) == Kind::none);
}
