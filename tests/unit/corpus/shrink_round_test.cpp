#include <catch2/catch.hpp>

#include "corpus/shrink.hpp"
#include "exact/curve.hpp"
#include "generating/drafts.hpp"
#include "generating/regime.hpp"

using namespace manifuzz;

namespace {

/// A round case of a regime, from an index on, whose shapes have so many vertices at least.
PairCase round_case(std::string_view regime, int vertices) {
  for (std::uint64_t index = 0;; ++index) {
    const PairCase pair = generate(4, *find_regime(regime), index);
    const bool is_large = pair.a.polygon.count >= vertices && pair.b.polygon.count >= vertices;
    if (is_large && is_round(pair)) return pair;
  }
}

/// Where round shapes stay round, whatever else changes.
bool are_still_round(const PairCase& pair) {
  return is_round(pair);
}

double least_depth(const PairCase& pair) {
  const exact::Truth truth(pair);
  return exact::PenetrationCurve(truth, exact::Skin::round).least();
}

}  // namespace

TEST_CASE("round polygons shrink to the plainest circle and polygon, or segments") {
  const Shrunk shrunk = shrink(round_case("round_corners", 5), are_still_round);
  CHECK(shrunk.complete);
  CHECK(shrunk.pair.a.polygon.count == 1);
  CHECK(shrunk.pair.b.polygon.count == 1);
  CHECK(shrunk.pair.a.polygon.radius == 1);
  CHECK(shrunk.pair.b.polygon.radius == 1);
}

TEST_CASE("a polygon becomes a capsule where an edge must stay, and a circle where none must") {
  const auto has_edge = [](const PairCase& p) { return is_round(p) && p.a.polygon.count >= 2; };
  const Shrunk shrunk = shrink(round_case("round_corners", 5), has_edge);
  CHECK(shrunk.pair.a.polygon.count == 2);
  CHECK(shrunk.pair.a.polygon.radius == 0);
  CHECK(shrunk.pair.b.polygon.count == 1);
}

TEST_CASE("round corners become mitred where nothing needs them round") {
  const PairCase start = round_case("round_corners", 5);
  const auto polygons = [](const PairCase& p) {
    return p.a.polygon.count >= 3 && p.b.polygon.count >= 3 && p.a.polygon.radius > 0;
  };
  const Shrunk mitred = shrink(start, polygons);
  CHECK_FALSE(is_round(mitred.pair));
  CHECK(mitred.pair.a.polygon.radius == 1);
  const auto round_polygons = [&](const PairCase& p) {
    return polygons(p) && p.a.polygon.is_round();
  };
  const Shrunk round = shrink(start, round_polygons);
  CHECK(round.pair.a.polygon.is_round());
  CHECK_FALSE(round.pair.b.polygon.is_round());
}

TEST_CASE("polygons of mitred pairs stay polygons") {
  const PairCase start = generate(1, *find_regime("generic"), 3);
  rc::seq::forEach(simpler_cases(start),
                   [](const PairCase& simpler) { CHECK_FALSE(is_round(simpler)); });
}

TEST_CASE("radii shrink to numbers that read well") {
  const auto wide = [](const PairCase& p) {
    return p.a.polygon.count == 1 && p.a.polygon.radius > 2.5F;
  };
  PairCase start = round_case("circles", 1);
  const std::array<Vector2<float>, 1> center{Vector2<float>(0, 0)};
  start.a.polygon = make_polygon<float>(center, 7.654321F);
  CHECK(shrink(start, wide).pair.a.polygon.radius == 3);
}

TEST_CASE("what a plain round case shows has one normal form, wherever it was found") {
  const auto overlap = [](const PairCase& p) { return is_round(p) && least_depth(p) > 0.1; };
  std::vector<PairCase> forms;
  for (std::uint64_t i = 0; forms.size() < 12; ++i) {
    const PairCase pair = generate(9, *find_regime("mixed_shapes"), i);
    if (overlap(pair)) forms.push_back(shrink(pair, overlap).pair);
  }
  for (const PairCase& form : forms) CHECK(form == forms.front());
  CHECK(complexity(forms.front()).vertices == 2);
}

TEST_CASE("every simpler case of a round one is valid and simpler") {
  for (const char* const regime : {"circles", "capsules", "mixed_shapes", "large_radii"}) {
    for (std::uint64_t index = 0; index < 3; ++index) {
      const PairCase pair = generate(2, *find_regime(regime), index);
      rc::seq::forEach(simpler_cases(pair), [&](const PairCase& simpler) {
        CHECK(complexity(simpler) < complexity(pair));
        CHECK(revalidated(simpler).has_value());
      });
    }
  }
}
