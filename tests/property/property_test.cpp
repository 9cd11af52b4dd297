#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "campaign/replay.hpp"
#include "support/installed_collider.hpp"
#include "support/named_tests.hpp"
#include "support/source_tree.hpp"

// Every property of every built-in collider is a test of its own. Seeded by MANIFUZZ_SEED, so that
// each commit looks elsewhere; a failure prints the RC_PARAMS that repeat it.

using namespace manifuzz;

namespace {

std::uint64_t seed() {
  const char* const text = std::getenv("MANIFUZZ_SEED");
  return text == nullptr ? 1 : std::strtoull(text, nullptr, 10);
}

int cases() {
  const char* const text = std::getenv("MANIFUZZ_PROPERTY_CASES");
  return text == nullptr ? 4000 : std::atoi(text);
}

void run(const Property& property, const Collider& collider) {
  const PropertyResult result = run_property(property, collider, {seed(), cases(), {}, {}});
  std::cout << property.sentence << "\n" << result.report << "\n";
  INFO(result.report << "\n" << result.why << "\nRC_PARAMS=\"" << result.reproduce << "\"");
  CHECK(result.passed);
  CHECK(result.cases > 0);
}

/// Other engines may be right in ways that most properties do not allow for.
bool has_every_property(std::string_view collider) {
  return collider == "clip" || collider == "clip64" || collider == "pair" || collider == "gjk" ||
         collider == "gjk64" || collider.starts_with("batch") || collider == "box2d";
}

/// The others are wrong in ways that nobody has named, too.
bool is_explained_in_full(std::string_view collider) {
  const bool is_linked = std::ranges::any_of(
      linked_colliders(), [&](const ColliderEntry& entry) { return entry.name == collider; });
  if (!is_linked) return collider == "planck" || collider == "phaser-box2d";
  return !collider.starts_with("bullet-") && !collider.starts_with("libccd-");
}

[[maybe_unused]] const bool registered = [] {
  for (const ColliderEntry& entry : colliders()) {
    if (!is_explained_in_full(entry.name)) continue;
    for (const Property& property : properties()) {
      if (!has_every_property(entry.name) && property.name != "admissible") continue;
      test::add_test(std::string(entry.name) + ": " + std::string(property.sentence), "[property]",
                     [&property, &entry] {
                       const auto collider = test::installed_collider(entry.name);
                       if (collider) run(property, *collider);
                     });
    }
  }
  return true;
}();

/// A collider that answers as clip does, but leaves out contacts shallower than a length.
Collider without_shallow_contacts() {
  Collider collider = find_collider("clip");
  const auto right = collider.collide;
  collider.collide = [right](const PairCase& pair) {
    const auto manifold = std::get<Manifold<double>>(right(pair));
    const bool is_deep = manifold.count > 0 && manifold.points[0].depth > 0.5;
    return Answer(is_deep ? manifold : Manifold<double>());
  };
  collider.with_tie_bias = nullptr;
  return collider;
}

/// A collider that answers as clip does, but each depth a hundredth too large.
Collider wrong_depths() {
  Collider collider = find_collider("clip");
  const auto right = collider.collide;
  collider.collide = [right](const PairCase& pair) {
    auto manifold = std::get<Manifold<double>>(right(pair));
    for (int i = 0; i < manifold.count; ++i) manifold.points[i].depth *= 1.01;
    return Answer(manifold);
  };
  return collider;
}

}  // namespace

TEST_CASE("a failing property is shrunk, says why, and repeats from its string") {
  const Property* const property = find_by_name(properties(), "depth-is-overlap");
  REQUIRE(property != nullptr);
  const Collider broken = wrong_depths();
  const PropertyResult result = run_property(*property, broken, {7, 2000, {}, {}});
  REQUIRE_FALSE(result.passed);
  REQUIRE(result.failing.has_value());
  CHECK(result.failing->a.polygon.count + result.failing->b.polygon.count <= 7);
  CHECK(check(*property, broken, *result.failing).kind == PropertyOutcome::Kind::fails);
  const PropertyResult again = run_property(*property, broken, {8, 1, {}, result.reproduce});
  REQUIRE(again.failing.has_value());
  CHECK(*again.failing == *result.failing);
}

TEST_CASE("the report of a failing property names no source file") {
  const Property* const property = find_by_name(properties(), "depth-is-overlap");
  REQUIRE(property != nullptr);
  const PropertyResult result = run_property(*property, wrong_depths(), {7, 2000, {}, {}});
  REQUIRE_FALSE(result.passed);
  CHECK(result.report.find(result.why) != std::string::npos);
  CHECK(result.report.find(".cpp") == std::string::npos);
  CHECK(result.report.find(test::source_dir().string()) == std::string::npos);
}

TEST_CASE("what the ledger explains of round shapes fails no property") {
  const CorpusCase witness = read_case_file(
      (test::source_dir() / "corpus/defects/box2d/witness-box2d-edge-slab-not-widened.json")
          .string());
  REQUIRE(is_round(witness.pair()));
  const Property* const property = find_by_name(properties(), "admissible");
  CHECK(check(*property, find_collider("box2d"), witness.pair()).kind ==
        PropertyOutcome::Kind::known);
}

TEST_CASE("scaling is asked of colliders without a length of their own alone") {
  const Property* const property = find_by_name(properties(), "powers-of-two");
  REQUIRE(property != nullptr);
  const Vector2<float> box[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  PairCase pair{{make_polygon<float>(box), {}}, {make_polygon<float>(box), {}}};
  pair.b.pose.position = {1.75F, 0.5F};
  const auto kind_of = [&](auto declare) {
    Collider collider = without_shallow_contacts();
    declare(collider.declaration);
    return check(*property, collider, pair).kind;
  };
  using Kind = PropertyOutcome::Kind;
  CHECK(kind_of([](Declaration&) {}) == Kind::fails);
  CHECK(kind_of([](Declaration& d) { d.tolerance.relative = 0.01; }) == Kind::fails);
  CHECK(kind_of([](Declaration& d) { d.tie_bias.relative = 0.01; }) == Kind::fails);
  CHECK(kind_of([](Declaration& d) { d.tie_bias.absolute = 0.01; }) == Kind::not_applicable);
  CHECK(kind_of([](Declaration& d) { d.speculative = 0.5; }) == Kind::not_applicable);
  CHECK(kind_of([](Declaration& d) { d.least_depth = 0.5; }) == Kind::not_applicable);
  CHECK(kind_of([](Declaration& d) { d.tolerance.absolute = 0.5; }) == Kind::not_applicable);
}

TEST_CASE("a depth that is no number fails by a finite magnitude") {
  Collider broken = find_collider("clip");
  const auto right = broken.collide;
  broken.collide = [right](const PairCase& pair) {
    auto manifold = std::get<Manifold<double>>(right(pair));
    if (pair.a.polygon.count == 3) manifold.points[0].depth = NAN;
    return Answer(manifold);
  };
  const Vector2<float> triangle[] = {{0, 0}, {2, 0.5F}, {0.5F, 2}};
  const Vector2<float> box[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  PairCase pair{{make_polygon<float>(box), {}}, {make_polygon<float>(triangle), {}}};
  pair.b.pose.position = {0.75F, 0.125F};
  const PropertyOutcome outcome =
      check(*find_by_name(properties(), "swapping-mirrors"), broken, pair);
  CHECK(outcome.kind == PropertyOutcome::Kind::fails);
  CHECK(std::isfinite(outcome.magnitude));
}

TEST_CASE("a string that repeats nothing is a user's error") {
  const Collider clip = find_collider("clip");
  CHECK_THROWS_AS(run_property(properties()[0], clip, {1, 1, {}, "reproduce=xx"}), UserError);
}

TEST_CASE("a collider that does not clip is not where it says") {
  // B's upper edge runs from far left of A's lower face to far right of it.
  const Vector2<float> a[] = {{-1, 0}, {1, 0}, {0, 2}};
  const Vector2<float> b[] = {{-9, -1}, {9, -1}, {9, 0.5F}, {-9, 0.5F}};
  const PairCase pair{{make_polygon<float>(a), {}}, {make_polygon<float>(b), {}}};
  Collider unclipped = find_collider("clip");
  const auto right = unclipped.collide;
  unclipped.collide = [right](const PairCase& case_given) {
    auto manifold = std::get<Manifold<double>>(right(case_given));
    const Feature face{Feature::Kind::face, 0};
    manifold.points[0].position = {-9, 0.5};
    manifold.points[0].features = {face, {Feature::Kind::vertex, 3}};
    manifold.points[1].position = {9, 0.5};
    manifold.points[1].features = {face, {Feature::Kind::vertex, 2}};
    return Answer(manifold);
  };
  const Property* const property = find_by_name(properties(), "points-in-place");
  REQUIRE(property != nullptr);
  CHECK(check(*property, find_collider("clip"), pair).kind == PropertyOutcome::Kind::holds);
  CHECK(check(*property, unclipped, pair).why == "a point outside the slab");
}

TEST_CASE("the same seed gives the same report") {
  const Property* const property = find_by_name(properties(), "never-empty");
  REQUIRE(property != nullptr);
  const Collider clip = find_collider("clip");
  const std::string once = run_property(*property, clip, {3, 500, {}, {}}).report;
  CHECK(run_property(*property, clip, {3, 500, {}, {}}).report == once);
  CHECK(run_property(*property, clip, {4, 500, {}, {}}).report != once);
}
