#include "measure/referee.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// Two squares of side 2, B above A by less than 2.
PairCase squares(float height, float far = 0) {
  const Vector2<float> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Body body;
  body.polygon = make_polygon<float>(corners);
  PairCase pair{body, body};
  pair.a.pose.position = {far, 0};
  pair.b.pose.position = {far + 0.5F, height};
  return pair;
}

const Declaration& of_clip() {
  static const Collider clip = make_clip();
  return clip.declaration;
}

Manifold<double> right_answer(const PairCase& pair) {
  return std::get<Manifold<double>>(make_clip().collide(pair));
}

Assessment assessed(const PairCase& pair, const Answer& answer,
                    const Declaration& declaration = of_clip()) {
  Referee referee(pair);
  return referee.measure(declaration, referee.whole(declaration, answer)).assessment;
}

}  // namespace

TEST_CASE("what is right is measured, what is wrong named") {
  const PairCase pair = squares(1.75F);
  const Manifold<double> right = right_answer(pair);
  REQUIRE(right.count == 2);
  CHECK(assessed(pair, right) == Assessment::right);
  CHECK(assessed(pair, Manifold<double>{}) == Assessment::missed);
  CHECK(assessed(squares(2.25F), right) == Assessment::phantom);
  Manifold<double> one = right;
  one.count = 1;
  CHECK(assessed(pair, one) == Assessment::wrong_count);
  Manifold<double> shifted = right;
  shifted.points[0].position.x() += 0.1;
  CHECK(assessed(pair, shifted) == Assessment::gross);
  Manifold<double> nonsense = right;
  nonsense.points[1].depth = std::nan("");
  CHECK(assessed(pair, nonsense) == Assessment::lost);
  CHECK(assessed(pair, Lost{}) == Assessment::lost);
  CHECK(assessed(pair, Unsupported{}) == Assessment::unsupported);
}

TEST_CASE("points that are slightly off, or bear another's features, are counted all the same") {
  const PairCase pair = squares(1.75F);
  const Manifold<double> right = right_answer(pair);
  Manifold<double> twice = right;
  twice.points[1] = twice.points[0];
  CHECK(assessed(pair, twice) == Assessment::wrong_count);
  twice.points[1].depth += 1e-4;
  CHECK(assessed(pair, twice) == Assessment::wrong_count);
  Manifold<double> one = right;
  one.count = 1;
  one.points[0].features = right.points[1].features;
  CHECK(assessed(pair, one) == Assessment::wrong_count);
  Manifold<double> deeper = right;
  deeper.points[1].depth += 1e-4;
  CHECK(assessed(pair, deeper) == Assessment::right);
}

TEST_CASE("errors are shares of the size, of the bound, and roundoffs of the extent") {
  const PairCase pair = squares(1.75F);
  Manifold<double> deeper = right_answer(pair);
  const double off = 0x1p-20;
  deeper.points[0].depth += off;
  Referee referee(pair);
  const Measured measured = referee.measure(of_clip(), deeper);
  REQUIRE(measured.has_errors);
  CHECK(measured.assessment == Assessment::right);  // beyond the bound, but not grossly
  CHECK(measured.of_size.depth == Approx(off / size(pair)));
  CHECK(measured.of_size.position == 0);
  CHECK(measured.of_size.normal == 0);
  const Bounds bound = bounds(pair, of_clip());
  CHECK(measured.of_bound.depth == Approx(off / bound.separation));
  CHECK(measured.of_extent == Approx(off * 0x1p24 / extent(pair)));
}

TEST_CASE(
    "no distance from the origin excuses a lost contact, a lost point or a gross error, or makes a "
    "case ill posed") {
  const PairCase far = squares(1.75F, 0x1p22F);
  const Declaration box2d = make_box2d().declaration;
  REQUIRE(
      is_ill_posed(size(far), bounds(far, box2d)));  // for the judge, by the collider's own frame
  CHECK(assessed(far, Manifold<double>{}, box2d) == Assessment::missed);
  const Manifold<double> right = right_answer(far);
  CHECK(assessed(far, right, box2d) == Assessment::right);
  Manifold<double> shifted = right;
  shifted.points[0].position.x() += 0.1;
  CHECK(assessed(far, shifted, box2d) == Assessment::gross);
  Manifold<double> one = right;
  one.count = 1;
  CHECK(assessed(far, one, box2d) == Assessment::wrong_count);
}

TEST_CASE("no distance from the origin makes a wrong face right, or excuses skins that overlap") {
  const Declaration box2d = make_box2d().declaration;
  for (const float far : {0.0F, 0x1p22F}) {
    CAPTURE(far);
    const PairCase pair = squares(1.75F, far);
    const exact::Truth truth(pair);
    const Manifold<double> sideways = true_manifold(truth.clip({Side::a, 1}, 3));
    REQUIRE(sideways.count == 2);
    REQUIRE(sideways.points[0].depth == Approx(1.5));  // where 0.25 is right
    CHECK(assessed(pair, sideways, box2d) == Assessment::gross);
    PairCase skins = squares(2.2F, far);
    skins.a.polygon.radius = skins.b.polygon.radius = 0.2F;
    CHECK(assessed(skins, right_answer(skins), box2d) == Assessment::right);
    CHECK(assessed(skins, Manifold<double>{}, box2d) == Assessment::missed);
  }
}

TEST_CASE("what a right collider may answer is neither missed nor phantom") {
  const float bound = static_cast<float>(bounds(squares(2), of_clip()).separation);
  const PairCase within = squares(2 - bound / 2);
  CHECK(assessed(within, Manifold<double>{}) == Assessment::right);
  CHECK(assessed(within, right_answer(within)) == Assessment::right);
  CHECK(assessed(squares(2 - 2 * bound), Manifold<double>{}) == Assessment::missed);
  CHECK(assessed(squares(2 + 2 * bound), right_answer(within)) == Assessment::phantom);
}

TEST_CASE("what float cannot tell is ill posed, and its errors are measured") {
  PairCase pair = squares(1.75F);
  for (auto& vertex : pair.b.polygon.vertices) vertex.x() += 0x1p22F;
  for (int i = 0; i < 4; ++i) pair.a.polygon.vertices[i].x() += 0x1p22F;
  Referee referee(pair);
  Manifold<double> deep = right_answer(pair);
  deep.points[0].depth += 1;
  const Measured measured = referee.measure(of_clip(), deep);
  CHECK(measured.assessment == Assessment::ill_posed);
  REQUIRE(measured.has_errors);
  CHECK(measured.of_size.depth > 0.25);
  CHECK(assessed(pair, make_clip64().collide(pair), make_clip64().declaration) ==
        Assessment::right);
}

TEST_CASE("the truth, rounded once, errs by at most its roundoff") {
  const PairCase pair = squares(1.7F);
  Referee referee(pair);
  const Manifold<double> ideal = rounded_once(referee.truth_for(of_clip()));
  REQUIRE(ideal.count == 2);
  const Measured measured = referee.measure(of_clip(), ideal);
  CHECK(measured.assessment == Assessment::right);
  CHECK(measured.of_extent <= 1);
}

}  // namespace manifuzz
