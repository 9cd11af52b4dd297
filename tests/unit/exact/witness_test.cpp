#include "exact/witness.hpp"

#include <array>
#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "support/named_tests.hpp"
#include "support/twin.hpp"
#include "support/twin_curve.hpp"

// Whether a contact point is one, against the twin: claims that are right, nearly so, and wrong by
// every size of error. MANIFUZZ_TWIN_CASES sets how many cases a regime.

namespace manifuzz {
namespace {

constexpr std::array<exact::Height, 2> kCores{{{1, 0, 0}, {0, 1, 0}}};
constexpr std::array<exact::Height, 1> kMiddle{{{0.5, 0.5, 0}}};

/// A normal whose length is a whole number: two legs of a triangle of whole numbers.
Vector2<double> rational_normal(Random& random, const PairCase& pair) {
  double angle = random.uniform(-1.57, 1.57);
  if (random.chance(0.6)) {
    const auto& normal = pair.a.polygon.normals[random.integer(0, pair.a.polygon.count - 1)];
    angle = static_cast<double>(std::atan(normal.y() / normal.x()));
  }
  const double steps = std::ldexp(1, random.integer(1, 24));
  const double half = std::round(steps * std::tan(angle / 2));
  const Vector2<double> found(steps * steps - half * half, 2 * steps * half);
  return random.chance(0.5) ? found : Vector2<double>(-found);
}

/// 0, or any power of two below 1.
double error_size(Random& random) {
  return random.chance(0.2) ? 0 : std::ldexp(1, -random.integer(0, 60));
}

/// What a vertex of either says of itself, more or less.
exact::PointClaim any_claim(Random& random, const exact::Truth& truth, const exact::Along& along) {
  const PairCase& pair = truth.pair();
  const double extent = truth.extent();
  const auto error = [&] { return (random.chance(0.5) ? 1 : -1) * error_size(random) * extent; };
  exact::PointClaim claim;
  const Side side = random.chance(0.5) ? Side::a : Side::b;
  const auto corner = pair[side].polygon.vertices[random.integer(0, pair[side].polygon.count - 1)];
  const Pose<double> pose{pair[side].pose.position.cast<double>(),
                          pair[side].pose.rotation.cast<double>()};
  claim.position =
      to_local(pair.a.pose, transform<double>(pose, Vector2<double>(corner.cast<double>())));
  claim.position += Vector2<double>(error(), error());
  claim.heights = random.chance(0.5) ? std::span<const exact::Height>(kCores) : kMiddle;
  claim.gap_most = (along.meets() ? along.gap() : 0) + error();
  claim.gap_least = random.chance(0.5) ? claim.gap_most : 0;
  claim.along = std::abs(error());
  claim.across = std::abs(error());
  claim.slack = std::abs(error());
  claim.narrow = std::abs(error());
  if (random.chance(0.5)) claim.shortfall = std::abs(error());
  return claim;
}

void compare_witnesses(const Regime& regime) {
  int found = 0;
  for (std::uint64_t i = 0; i < twin_cases(150); ++i) {
    PairCase pair = generate(31, regime, i);
    pair.a.pose.rotation = {0, 1};
    const exact::Truth truth(pair);
    const twin::TwinCurve twin(pair, false);
    Random random(31, "witnesses", i);
    const Vector2<double> normal = rational_normal(random, pair);
    const exact::Along along(truth, normal);
    std::string line;
    append_case_line(line, pair);
    INFO(line << "index " << i << ", normal " << normal.x() << ", " << normal.y());
    const double slide = error_size(random) * truth.extent();
    const auto most = twin.most_gap(normal, slide);
    const auto least = twin.least_gap(normal, slide);
    REQUIRE(along.meets(slide) == most.has_value());
    for (const double length : {along.meets() ? along.gap() : 0, along.depth(), 0.0}) {
      if (most) REQUIRE(along.compare_gap(length, slide) == sign(*most - Real(length)));
      REQUIRE(along.compare_least_gap(length, slide) == (least ? sign(*least - Real(length)) : -1));
    }
    for (int k = 0; k < 4; ++k) {
      const exact::PointClaim claim = any_claim(random, truth, along);
      const bool is_one = exact::is_witness(truth, along, claim);
      INFO("claim " << k);
      REQUIRE(is_one == twin.has_witness(normal, claim));
      found += is_one ? 1 : 0;
    }
  }
  CHECK(found > 0);
}

TEST_CASE(
    "a vertex that faces away is a witness where a core is narrow, whatever else is allowed") {
  const std::array<Vector2<float>, 4> box{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  // Its lower edge alone faces the box; its top is 2 above that.
  const std::array<Vector2<float>, 3> standing{{{0, 1}, {0.25F, 1.5F}, {0.125F, 3}}};
  const exact::Truth truth(
      {{make_polygon<float>(box, 0.0F), {}}, {make_polygon<float>(standing, 0.0F), {}}});
  const exact::Along up(truth, {0, 1});
  const auto is_one = [&](Vector2<double> position, double gap, double narrow) {
    const exact::PointClaim claim{.position = position,
                                  .heights = kCores,
                                  .gap_least = gap,
                                  .gap_most = gap,
                                  .along = 0.001,
                                  .across = 0.5,
                                  .slack = 0.001,
                                  .narrow = narrow};
    return exact::is_witness(truth, up, claim);
  };
  CHECK(is_one({0.125, 1.25}, -0.25, 0));
  CHECK(is_one({0.125, 3}, -2, 0.25));
  CHECK_FALSE(is_one({0.125, 3}, -2, 0.249));
  CHECK_FALSE(is_one({0.125, 4}, -3, 0.25));
  CHECK_FALSE(is_one({0.25, 3}, -2, 0.25));
}

[[maybe_unused]] const bool witness_registered = [] {
  for (const Regime& regime : polygon_regimes()) {
    test::add_test("a witness and its twin agree in the regime " + std::string(regime.name),
                   "[twin]", [&regime] { compare_witnesses(regime); });
  }
  return true;
}();

}  // namespace
}  // namespace manifuzz
