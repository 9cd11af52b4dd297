#include <algorithm>
#include <cstdio>
#include <string>

#include <catch2/catch.hpp>

#include "cases/regime.hpp"
#include "clipping/collider.hpp"
#include "judging/judge.hpp"
#include "judging/plain_error.hpp"
#include "oracle/box2d/box2d.hpp"

// How close right colliders come to their bounds: never past them, and not a thousand times short.

using namespace manifuzz;

namespace {

PlainError largest_share(const Collider& collider, const Regime& regime, std::uint64_t cases) {
  PlainError most;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const PairCase pair = generate(4, regime, i);
    const Admissible right = admissible(pair, collider.declaration);
    if (is_ill_posed(pair, right.bounds)) continue;
    const Answer answer = collider.collide(pair);
    const auto& manifold = std::get<Manifold<double>>(answer);
    if (collider.declaration.name != "box2d") {  // whose wrong answers the ledger names
      CHECK(mismatch(manifold, right).kind == Kind::none);
    }
    const auto measured = measure_error(manifold, right);
    if (!measured) continue;
    most.normal = std::max(most.normal, measured->share.normal);
    most.position = std::max(most.position, measured->share.position);
    most.depth = std::max(most.depth, measured->share.depth);
  }
  return most;
}

}  // namespace

TEST_CASE("every right collider comes to its bounds and never past them") {
  std::puts("largest error over bound   normal  position   depth");
  for (const Collider& collider : {make_clip(), make_clip64(), make_box2d()}) {
    for (const Regime& regime : regimes()) {
      const bool generic = regime.name == "generic";
      const PlainError most = largest_share(collider, regime, generic ? 20'000 : 2000);
      std::printf("%-8s %-16s  %7.3f  %8.3f  %6.3f\n", collider.declaration.name.c_str(),
                  std::string(regime.name).c_str(), most.normal, most.position, most.depth);
      CHECK(most.normal <= 1);
      CHECK(most.position <= 1);
      CHECK(most.depth <= 1);
      if (!generic) continue;
      CHECK(std::max({most.normal, most.position, most.depth}) >= 0.1);
      CHECK(most.position >= 0.05);
      CHECK(most.depth >= 0.05);
    }
  }
}

TEST_CASE("an error is measured to past double") {
  const Vector2<float> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  PairCase pair{{make_polygon<float>(corners), {}}, {make_polygon<float>(corners), {}}};
  pair.b.pose.position = {0.3F, 1.75F};
  const Collider clip64 = make_clip64();
  auto manifold = std::get<Manifold<double>>(clip64.collide(pair));
  const Admissible right = admissible(pair, clip64.declaration);
  CHECK(measure_error(manifold, right)->error.depth <= 1e-16);
  manifold.points[0].depth += 0x1p-52;
  CHECK(measure_error(manifold, right)->error.depth >= 0x1p-53);
  manifold.count = 0;
  CHECK(!measure_error(manifold, right));
}
