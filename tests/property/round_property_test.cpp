#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/replay.hpp"
#include "engines/colliders.hpp"
#include "support/named_tests.hpp"

// Each property of round shapes can fail: a collider with a bug that acts on round pairs alone is
// noticed by it.

using namespace manifuzz;

namespace {

using Change = void (*)(const PairCase& pair, Manifold<double>& manifold);

/// A collider that answers as clip does, but for a change to its answers to round pairs.
Collider with_bug(Change change) {
  Collider collider = find_collider("clip");
  const auto right = collider.collide;
  collider.collide = [right, change](const PairCase& pair) {
    auto manifold = std::get<Manifold<double>>(right(pair));
    if (is_round(pair) && manifold.count > 0) change(pair, manifold);
    return Answer(manifold);
  };
  collider.with_tie_bias = nullptr;
  collider.in_double = [] { return find_collider("clip64"); };
  return collider;
}

void deepen(Manifold<double>& manifold, double factor) {
  for (int i = 0; i < manifold.count; ++i) manifold.points[i].depth *= factor;
}

void turn_normal(Manifold<double>& manifold) {
  manifold.normal = rotate<double>({0.8, 0.6}, manifold.normal);
}

bool has(const PairCase& pair, int vertices) {
  return pair.a.polygon.count == vertices || pair.b.polygon.count == vertices;
}

/// A bug, and the property that must notice it.
struct Planted {
  std::string_view property;
  std::string_view bug;
  Change change;
};

constexpr Planted kPlanted[] = {
    {"swapping-mirrors", "a circle as B has its depth halved",
     [](const PairCase& pair, Manifold<double>& manifold) {
       if (pair.b.polygon.count == 1) deepen(manifold, 0.5);
     }},
    {"renumbering", "a segment's first vertex weighs more",
     [](const PairCase& pair, Manifold<double>& manifold) {
       const auto& first = pair.a.polygon.vertices[0];
       if (pair.a.polygon.count == 2 && first.x() < pair.a.polygon.vertices[1].x()) {
         deepen(manifold, 2);
       }
     }},
    {"quarter-turns", "normals depend on how the world is turned",
     [](const PairCase& pair, Manifold<double>& manifold) {
       if (pair.a.pose.rotation.x() < 0) turn_normal(manifold);
     }},
    {"translations", "places depend on where the world is",
     [](const PairCase& pair, Manifold<double>& manifold) {
       if (pair.a.pose.position.x() > 0.5F) deepen(manifold, 1.5);
     }},
    {"powers-of-two", "a length of its own is added to depths",
     [](const PairCase&, Manifold<double>& manifold) { manifold.points[0].depth += 0.001; }},
    {"depth-is-overlap", "depths are a hundredth too large",
     [](const PairCase&, Manifold<double>& manifold) { deepen(manifold, 1.01); }},
    {"depth-moves-apart", "normals are turned",
     [](const PairCase&, Manifold<double>& manifold) { turn_normal(manifold); }},
    {"float-and-double", "float is shallower than double",
     [](const PairCase&, Manifold<double>& manifold) { deepen(manifold, 0.9); }},
    {"never-empty", "shallow contacts are left out",
     [](const PairCase& pair, Manifold<double>& manifold) {
       if (manifold.points[0].depth < 0.1 * size(pair)) manifold = {};
     }},
    {"admissible", "the second point is always missing",
     [](const PairCase&, Manifold<double>& manifold) { manifold.count = 1; }},
    {"circles-turn", "a circle that is turned is less deep",
     [](const PairCase& pair, Manifold<double>& manifold) {
       const bool is_turned = pair.b.pose.rotation.y() > 0.5F;
       if (pair.b.polygon.count == 1 && is_turned) deepen(manifold, 0.99);
     }},
    {"circles-turn", "the normal to a circle turns with it",
     [](const PairCase& pair, Manifold<double>& manifold) {
       const bool is_turned = pair.b.pose.rotation.y() > 0.5F;
       if (pair.b.polygon.count == 1 && is_turned) turn_normal(manifold);
     }},
    {"capsules-are-hulls", "capsules are a hundredth less deep",
     [](const PairCase& pair, Manifold<double>& manifold) {
       if (has(pair, 2)) deepen(manifold, 0.99);
     }},
    {"capsules-are-hulls", "capsules are a hundredth deeper",
     [](const PairCase& pair, Manifold<double>& manifold) {
       if (has(pair, 2)) deepen(manifold, 1.01);
     }},
    {"capsules-are-hulls", "capsules are missed",
     [](const PairCase& pair, Manifold<double>& manifold) {
       if (has(pair, 2)) manifold = {};
     }},
    {"circles-are-limits", "circles are a quarter deeper",
     [](const PairCase& pair, Manifold<double>& manifold) {
       if (has(pair, 1)) deepen(manifold, 1.25);
     }},
    {"circles-are-limits", "circles are a quarter less deep",
     [](const PairCase& pair, Manifold<double>& manifold) {
       if (has(pair, 1)) deepen(manifold, 0.75);
     }},
};

[[maybe_unused]] const bool planted_registered = [] {
  for (const Planted& planted : kPlanted) {
    test::add_test(
        fmt::format("the property {} notices that {}", planted.property, planted.bug), "[property]",
        [&planted] {
          const Property* const property = find_by_name(properties(), planted.property);
          REQUIRE(property != nullptr);
          const Collider broken = with_bug(planted.change);
          const auto result = run_property(*property, broken, {5, 3000, {}, {}});
          REQUIRE_FALSE(result.passed);
          REQUIRE(result.failing.has_value());
          CHECK(is_round(*result.failing));
          const Collider clip = find_collider("clip");
          CHECK(check(*property, clip, *result.failing).kind != PropertyOutcome::Kind::fails);
        });
  }
  return true;
}();

PropertyOutcome checked(std::string_view name, const PairCase& pair) {
  return check(*find_by_name(properties(), name), find_collider("clip"), pair);
}

PairCase circle_in_box() {
  const std::array<Vector2<float>, 1> center{Vector2<float>(0.25F, 0)};
  const Vector2<float> box[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  PairCase pair{{make_polygon<float>(center, 0.5F), {}}, {make_polygon<float>(box), {}}};
  pair.b.pose.position = {0, -1.25F};
  return pair;
}

}  // namespace

TEST_CASE("properties of round shapes are asked of the shapes that they name") {
  using Kind = PropertyOutcome::Kind;
  const PairCase circle = circle_in_box();
  CHECK(checked("circles-turn", circle).kind == Kind::holds);
  CHECK(checked("circles-are-limits", circle).kind == Kind::holds);
  CHECK(checked("capsules-are-hulls", circle).kind == Kind::not_applicable);
  PairCase capsule = circle;
  const std::array ends{Vector2<float>(0, 0), Vector2<float>(2, 0.5F)};
  capsule.a.polygon = make_polygon<float>(ends, 0.5F);
  CHECK(checked("capsules-are-hulls", capsule).kind == Kind::holds);
  CHECK(checked("circles-turn", capsule).kind == Kind::not_applicable);
  PairCase boxes = circle;
  boxes.a = boxes.b;
  CHECK(checked("circles-turn", boxes).kind == Kind::not_applicable);
  CHECK(checked("points-in-place", circle).kind == Kind::not_applicable);
}
