#include "exact/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <catch2/catch.hpp>

#include "exchange/json.hpp"
#include "generating/drafts.hpp"
#include "generating/regime.hpp"
#include "support/named_tests.hpp"
#include "support/twin.hpp"
#include "support/twin_curve.hpp"

// The penetration curve against its twin, in every regime, and what holds of every curve.
// MANIFUZZ_TWIN_CASES sets how many cases a regime.

namespace manifuzz {
namespace {

using exact::Along;
using exact::PenetrationCurve;
using exact::Skin;
using exact::Truth;

PairCase drawn(const Regime& regime, std::uint64_t index) {
  static const std::vector<PairCase> corpus = [] {
    std::vector<PairCase> pairs;
    for (std::uint64_t i = 0; i < 20; ++i) pairs.push_back(generate(3, *find_regime("grid"), i));
    return pairs;
  }();
  return generate(13, regime, index, {.corpus = corpus, .radius = {}});
}

/// A least one, a face's, one nearly so, or any: where decisions are near.
Vector2<double> any_normal(const PairCase& pair, const PenetrationCurve& curve, Random& random) {
  const double angle = random.uniform(0, 6.2831853);
  const Vector2<double> tilt(std::cos(angle), std::sin(angle));
  const Vector2<double> least = curve.minima(0).front();
  switch (random.integer(0, 4)) {
    case 0:
      return least;
    case 1:
      return least + std::ldexp(random.unit(), -random.integer(1, 50)) * tilt;
    case 2: {
      const auto& polygon = pair.a.polygon;
      return polygon.normals[random.integer(0, polygon.count - 1)].cast<double>();
    }
    case 3:
      return std::abs(tilt.x()) > std::abs(tilt.y()) ? Vector2<double>(1, 0)
                                                     : Vector2<double>(0, 1);
    default:
      return tilt;
  }
}

int sign_of_difference(const Real& value, double length) {
  return sign(value - Real(length));
}

/// Lengths at which a comparison with the value is hard, or easy.
std::array<double, 5> lengths_about(double value) {
  const double inf = std::numeric_limits<double>::infinity();
  return {value, std::nextafter(value, inf), std::nextafter(value, -inf), 0, 1.25 * value};
}

bool is_next_to(double value, const Real& truth, double extent) {
  return magnitude(truth - Real(value)) <= Real(0x1p-50 * extent + 0x1p-1000);
}

void compare_along(const Truth& truth, const PenetrationCurve& curve, const twin::TwinCurve& twin,
                   const Vector2<double>& normal) {
  INFO("normal " << normal.x() << ", " << normal.y());
  const Along along(truth, normal);
  const Real depth = twin.depth(normal);
  REQUIRE(is_next_to(along.depth(), depth, truth.extent()));
  for (const double length : lengths_about(along.depth())) {
    REQUIRE(along.compare_depth(length) == sign_of_difference(depth, length));
  }
  for (const double bound : lengths_about(curve.excess(along))) {
    REQUIRE(curve.compare_excess(along, bound) == sign_of_difference(depth - twin.least(), bound));
  }
  const auto gap = twin.gap(normal);
  REQUIRE(along.meets() == gap.has_value());
  if (!gap) return;
  REQUIRE(*gap <= depth);
  for (const double length : lengths_about(along.gap())) {
    REQUIRE(along.compare_gap(length) == sign_of_difference(*gap, length));
  }
}

void compare(const PairCase& pair, Skin skin, Random& random) {
  const Truth truth(pair);
  const PenetrationCurve curve(truth, skin);
  const twin::TwinCurve twin(pair, skin == Skin::round);
  REQUIRE(is_next_to(curve.least(), twin.least(), truth.extent()));
  for (const double length : lengths_about(curve.least())) {
    REQUIRE(curve.compare_least(length) == sign_of_difference(twin.least(), length));
  }
  compare_along(truth, curve, twin, any_normal(pair, curve, random));
}

void compare_all(const Regime& regime) {
  for (std::uint64_t i = 0; i < twin_cases(250); ++i) {
    const PairCase pair = drawn(regime, i);
    std::string line;
    append_case_line(line, pair);
    const Skin skin = i % 2 == 0 ? Skin::mitred : Skin::round;
    INFO(line << (skin == Skin::round ? "round" : "mitred") << ", index " << i);
    Random random(13, "normals", i);
    compare(pair, skin, random);
  }
}

[[maybe_unused]] const bool curve_registered = [] {
  for (const Regime& regime : polygon_regimes()) {
    test::add_test("the curve and its twin agree in the regime " + std::string(regime.name),
                   "[twin]", [&regime] { compare_all(regime); });
  }
  return true;
}();

/// Cases of all regimes in turn.
template <class Check>
void for_many(const Check& check) {
  constexpr std::uint64_t kCases = 40;
  for (const Regime& regime : polygon_regimes()) {
    for (std::uint64_t i = 0; i < kCases; ++i) {
      INFO(regime.name << ", index " << i);
      Random random(17, "curves", i);
      check(drawn(regime, i), random);
    }
  }
}

/// A way to move a pair, and how a normal in A's frame goes with it.
struct Motion {
  const char* name;
  std::optional<PairCase> (*pair)(PairCase);
  Vector2<double> (*normal)(const PairCase& pair, const Vector2<double>&);
};

Vector2<double> unchanged(const PairCase&, const Vector2<double>& normal) {
  return normal;
}

std::optional<PairCase> mirrored(PairCase pair) {
  for (const Side side : {Side::a, Side::b}) {
    auto& [polygon, pose] = pair[side];
    std::reverse(polygon.vertices.begin(), polygon.vertices.begin() + polygon.count);
    for (auto& v : polygon.vertices) v.x() = -v.x();
    pose.position.x() = -pose.position.x();
    pose.rotation.y() = -pose.rotation.y();
  }
  return revalidated(pair);
}

/// Where the rotations are quarter turns, a normal changes frames without rounding.
std::optional<PairCase> with_quarter_turns(PairCase pair) {
  pair.a.pose.rotation = {0, 1};
  pair.b.pose.rotation = {-1, 0};
  return pair;
}

const Motion kMotions[] = {
    {"swapped",
     [](PairCase pair) {
       return std::optional(PairCase{pair.b, pair.a});
     },
     [](const PairCase& pair, const Vector2<double>& normal) {
       const Vector2<double> a = pair.a.pose.rotation.cast<double>();
       const Vector2<double> b = pair.b.pose.rotation.cast<double>();
       return Vector2<double>(-rotate_back<double>(b, rotate<double>(a, normal)));
     }},
    {"mirrored", mirrored,
     [](const PairCase&, const Vector2<double>& n) { return Vector2<double>(-n.x(), n.y()); }},
    {"turned by a quarter",
     [](PairCase pair) {
       turn_by_quarter(pair);
       return std::optional(pair);
     },
     unchanged},
    {"renumbered",
     [](PairCase pair) {
       renumber(pair.a.polygon);
       renumber(pair.b.polygon);
       return std::optional(pair);
     },
     unchanged}};

/// That both curves are the same, to the last bit of every comparison.
void check_same(const PairCase& one, const Vector2<double>& normal_of_one, const PairCase& other,
                const Vector2<double>& normal_of_other, Skin skin) {
  const Truth truth(one);
  const Truth other_truth(other);
  const PenetrationCurve curve(truth, skin);
  const PenetrationCurve other_curve(other_truth, skin);
  const Along along(truth, normal_of_one);
  const Along other_along(other_truth, normal_of_other);
  for (const double length : lengths_about(curve.least())) {
    REQUIRE(curve.compare_least(length) == other_curve.compare_least(length));
  }
  for (const double length : lengths_about(along.depth())) {
    REQUIRE(along.compare_depth(length) == other_along.compare_depth(length));
  }
  for (const double bound : lengths_about(curve.excess(along))) {
    REQUIRE(curve.compare_excess(along, bound) == other_curve.compare_excess(other_along, bound));
  }
  REQUIRE(along.meets() == other_along.meets());
  for (const double length : lengths_about(along.meets() ? along.gap() : 0)) {
    REQUIRE(along.compare_gap(length) == other_along.compare_gap(length));
  }
  REQUIRE(curve.minima(0).size() == other_curve.minima(0).size());
}

}  // namespace

TEST_CASE("the least depth is R - S where cores overlap or are mitred, and else no more") {
  for_many([](const PairCase& pair, Random&) {
    const Truth truth(pair);
    const PenetrationCurve mitred(truth, Skin::mitred);
    const PenetrationCurve round(truth, Skin::round);
    REQUIRE(round.least() <= mitred.least());
    for (const double length : lengths_about(mitred.least())) {
      REQUIRE(mitred.compare_least(length) == -truth.compare_contact(-length));
      if (truth.compare_separation(0) > 0) continue;
      REQUIRE(round.compare_least(length) == mitred.compare_least(length));
    }
  });
}

TEST_CASE("no normal has less depth than the least, and the least has no excess within rounding") {
  for_many([](const PairCase& pair, Random& random) {
    const Truth truth(pair);
    for (const Skin skin : {Skin::mitred, Skin::round}) {
      const PenetrationCurve curve(truth, skin);
      const Along any(truth, any_normal(pair, curve, random));
      if (skin == Skin::round) REQUIRE(curve.compare_excess(any, 0) >= 0);
      const Along least(truth, curve.minima(0).front());
      REQUIRE(curve.compare_excess(least, 0x1p-50 * truth.extent()) <= 0);
    }
  });
}

TEST_CASE("swapping, mirroring, turning and renumbering leave the curve as it is") {
  const Motion& motion = GENERATE(from_range(std::begin(kMotions), std::end(kMotions)));
  INFO(motion.name);
  for_many([&](const PairCase& drawn_pair, Random& random) {
    const PairCase pair = *with_quarter_turns(drawn_pair);
    const auto moved = motion.pair(pair);
    if (!moved) return;
    const Skin skin = random.chance(0.5) ? Skin::round : Skin::mitred;
    const Truth truth(pair);
    const auto normal = any_normal(pair, PenetrationCurve(truth, skin), random);
    check_same(pair, normal, *moved, motion.normal(pair, normal), skin);
  });
}

}  // namespace manifuzz
