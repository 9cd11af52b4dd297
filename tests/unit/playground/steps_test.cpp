#include "playground/steps.hpp"

#include <catch2/catch.hpp>

#include "generating/regime.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;
using playground::Steps;
using playground::Way;

namespace {

struct Shapes {
  ConvexPolygon<double> a;
  ConvexPolygon<double> b;
};

/// Both in A's frame.
Shapes placed(const PairCase& pair) {
  const auto given = clipping::placed_pair<double>(pair);
  return {given.a, transform(relative_pose(given.pose_a, given.pose_b), given.b)};
}

/// What the steps come to, by what each says it left.
Manifold<double> kept_by(const Steps& steps, const Shapes& shapes) {
  Manifold<double> kept;
  const double total_radius = shapes.a.radius + shapes.b.radius;
  const bool from_a = steps.features->reference_side == Side::a;
  kept.reference = steps.features->reference_side;
  kept.normal = from_a ? steps.outward : Vector2<double>(-steps.outward);
  if (!steps.side_clips[1].leaves) return kept;
  for (const int i : {1, 0}) {
    if (steps.in_front[i] > total_radius) continue;
    const auto& end = steps.side_clips[1].edge[i];
    FeaturePair features{end.reference, end.incident};
    if (!from_a) std::swap(features.a, features.b);
    kept.points[kept.count++] = {end.position, total_radius - steps.in_front[i], features};
  }
  if (are_round(shapes.a, shapes.b)) clipping::put_on_surface(shapes.a, shapes.b, kept);
  return kept;
}

/// Asks for the steps of cases of each of the regimes.
template <class Check>
void for_each_case(std::span<const Regime> regimes, const Check& check) {
  for (const Regime& regime : regimes) {
    for (std::uint64_t i = 0; i < 300; ++i) {
      const PairCase pair = generate(1, regime, i);
      const Shapes shapes = placed(pair);
      INFO(regime.name << " " << i);
      check(pair, shapes, playground::steps_of(shapes.a, shapes.b));
    }
  }
}

}  // namespace

TEST_CASE(
    "the steps of two polygons end in the manifold of the library, but where it replaces it") {
  int clipped = 0;
  int replaced = 0;
  for_each_case(polygon_regimes(), [&](const PairCase&, const Shapes& shapes, const Steps& steps) {
    REQUIRE(steps.manifold == clipping::collide_in_frame(shapes.a, shapes.b));
    REQUIRE((steps.way == Way::apart || steps.way == Way::faces));
    if (steps.way == Way::apart) {
      REQUIRE(steps.manifold.count == 0);
      return;
    }
    const bool is_same = kept_by(steps, shapes) == steps.manifold;
    REQUIRE(is_same == !steps.is_replaced);
    ++clipped;
    replaced += steps.is_replaced ? 1 : 0;
  });
  CHECK(clipped > 1000);
  CHECK(replaced * 20 < clipped);
}

TEST_CASE("the steps of round shapes end in the manifold of the library") {
  std::array<int, 4> ways{};
  for_each_case(round_regimes(), [&](const PairCase&, const Shapes& shapes, const Steps& steps) {
    ++ways[static_cast<std::size_t>(steps.way)];
    REQUIRE(steps.manifold == clipping::collide_in_frame(shapes.a, shapes.b));
    REQUIRE((steps.way == Way::apart) == (steps.manifold.count == 0));
    if (steps.way == Way::faces && !steps.is_replaced) {
      REQUIRE(kept_by(steps, shapes) == steps.manifold);
    }
    if (steps.way == Way::cores) {
      REQUIRE(steps.nearest);
      if (steps.manifold.count == 2) REQUIRE(steps.features);
    }
  });
  for (const int count : ways) CHECK(count > 100);
}
