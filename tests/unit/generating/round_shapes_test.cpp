#include <cmath>
#include <functional>
#include <map>
#include <string_view>

#include <catch2/catch.hpp>

#include "generating/drafts.hpp"
#include "generating/regime.hpp"
#include "unit/generating/check_sweeps.hpp"

// Regimes and sweeps of round shapes, measured from the stored floats.

namespace manifuzz {
namespace {

constexpr int kCases = 4000;

/// The direction of a segment in the world.
Vector2<double> direction(const Body& body) {
  const Vector2<double> edge = (body.polygon.vertices[1] - body.polygon.vertices[0]).cast<double>();
  return rotate<double>(body.pose.rotation.cast<double>(), edge);
}

double core_length(const Body& body) {
  return body.polygon.count == 1 ? 0 : direction(body).norm();
}

/// The radius of the rounder capsule, as a share of its core.
double roundness(const PairCase& pair) {
  double least = INFINITY;
  for (const Body* body : {&pair.a, &pair.b}) {
    if (body->polygon.count == 1) continue;
    least = std::min(least, static_cast<double>(body->polygon.radius) / core_length(*body));
  }
  return least;
}

/// Whether the knob does what it says.
const Knobs kRoundKnobs{
    {"capsule_angle",
     [](const PairCase& pair, double x) {
       const Vector2<double> a = direction(pair.a);
       const Vector2<double> b = direction(pair.b);
       // What rounding vertices and rotations to floats turns them by.
       return std::abs(std::abs(cross(a, b) / a.dot(b)) - x) <= 1e-6;
     }},
    {"roundness",
     [](const PairCase& pair, double x) { return std::abs(roundness(pair) - x) <= 1e-3 * x; }},
    {"core_distance",
     [](const PairCase& pair, double x) {
       const double wanted = x * size(pair);
       const double rounding =
           2 * ulp_of(extent(pair) + pair.a.pose.position.cast<double>().norm());
       const double off = exact::separation_of(exact::Truth(pair)) - wanted;
       return std::abs(off) <= 0.02 * wanted + rounding;
     }},
    {"round_distance",
     [](const PairCase& pair, double x) {
       return std::abs(pair.a.pose.position.cast<double>().norm() - x) <= 1e-6 * x;
     }},
};

}  // namespace

TEST_CASE("every case of every regime of round shapes is valid, and 8 in 10 touch or nearly") {
  for (const Regime& regime : round_regimes()) {
    INFO("regime " << regime.name);
    int invalid = 0;
    int touching = 0;
    int near = 0;
    int touching_or_near = 0;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      const PairCase pair = generate(1, regime, i);
      invalid += is_round(pair) && revalidated(pair) ? 0 : 1;
      const double distance = gap_of(pair);
      const bool is_near = std::abs(distance) <= 0.1 * size(pair);
      touching += distance <= 0 ? 1 : 0;
      near += is_near ? 1 : 0;
      touching_or_near += distance <= 0 || is_near ? 1 : 0;
    }
    CHECK(invalid == 0);
    CHECK(touching >= kCases / 4);
    CHECK(touching_or_near >= kCases * 8 / 10);
    if (regime.name != "cores_touch") CHECK(near >= kCases / 3);
  }
}

TEST_CASE("mixed shapes are of every kind, on either side") {
  std::map<std::pair<int, bool>, int> met;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const PairCase pair = generate(1, *find_regime("mixed_shapes"), i);
    for (const Body* body : {&pair.a, &pair.b}) {
      ++met[{std::min(body->polygon.count, kMinVertices), body->polygon.is_round()}];
    }
  }
  CHECK(met.size() == 4);
  for (const auto& [kind, times] : met) {
    INFO(kind.first << " vertices, round: " << kind.second);
    CHECK(times >= kCases / 10);
  }
}

TEST_CASE("regimes of round shapes give what a collider takes") {
  const GenerationContext circles{.corpus = {}, .radius = {}, .takes = [](const PairCase& pair) {
                                    return pair.a.polygon.count == 1 && pair.b.polygon.count == 1;
                                  }};
  int others = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    others += circles.takes(generate(1, *find_regime("circles"), i, circles)) ? 0 : 1;
  }
  CHECK(others == 0);
}

TEST_CASE("every step of every sweep of round shapes draws valid pairs, its knob turned") {
  check_sweeps(true, kRoundKnobs, 50);
}

}  // namespace manifuzz
