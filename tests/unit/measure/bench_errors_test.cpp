#include <catch2/catch.hpp>

#include "generating/regime.hpp"
#include "measure/bench/bench.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// `clip`, asked to do otherwise in one case.
BenchSubject altered(const std::string& name, const PairCase& where, const Answer& answer) {
  return {.name = name, .collider = [name, where, answer] {
            Collider collider = make_clip();
            collider.declaration.name = name;
            collider.collide = [clip = make_clip(), where, answer](const PairCase& pair) {
              return pair == where ? answer : clip.collide(pair);
            };
            return collider;
          }};
}

}  // namespace

TEST_CASE("bench measures by the referee: what is missed, phantom, lost, and the worst case") {
  std::vector<PairCase> pairs;
  const PairCase* touching = nullptr;
  const PairCase* apart = nullptr;
  for (std::uint64_t i = 0; i < 200; ++i) pairs.push_back(generate(1, *find_regime("generic"), i));
  for (const PairCase& pair : pairs) {
    const double separation = exact::Truth(pair).separation();
    if (separation < -0.1 * size(pair)) touching = &pair;
    if (separation > 0.1 * size(pair)) apart = &pair;
  }
  REQUIRE(touching != nullptr);
  REQUIRE(apart != nullptr);
  const Answer contact = make_clip().collide(*touching);
  Manifold<double> deeper = std::get<Manifold<double>>(contact);
  deeper.points[0].depth += 0x1p-24 * extent(*touching) * 1000;
  const auto errors = measure_errors({{.name = "clip", .collider = [] { return make_clip(); }},
                                      altered("misses", *touching, Manifold<double>{}),
                                      altered("sees", *apart, contact),
                                      altered("loses", *touching, Lost{}),
                                      altered("errs", *touching, deeper),
                                      {.name = "asks for no manifold"}},
                                     pairs);
  CHECK(errors.size() == 5);
  const BenchErrors& of_clip = errors.at("clip");
  CHECK(of_clip.cases == pairs.size());
  CHECK(of_clip.missed == 0);
  CHECK(of_clip.phantom == 0);
  CHECK(of_clip.of_extent.depth.max < 20);
  CHECK(errors.at("misses").missed == 1);
  CHECK(errors.at("sees").phantom == 1);
  CHECK(errors.at("loses").cases == pairs.size() - 1);
  const BenchErrors& errs = errors.at("errs");
  CHECK(errs.of_extent.depth.max == Approx(1000).margin(20));
  CHECK(errs.worst.at(errs.of_extent.depth.worst) == *touching);
}

}  // namespace manifuzz
