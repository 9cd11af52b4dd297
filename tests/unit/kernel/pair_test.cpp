#include "kernel/pair.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <rapidcheck.h>
#include <rapidcheck/state.h>

#include "base/random.hpp"
#include "clipping/collide.hpp"
#include "generating/regime.hpp"
#include "measure/stress/stress.hpp"
#include "unit/kernel/every_target.hpp"

// One pair at a time against the clean code, bit for bit; and what a hint may not change.

using namespace manifuzz;
using manifuzz::test::on_every_target;

namespace {

constexpr std::uint64_t kCases = 1000;

struct Pair {
  ConvexPolygon<float> a;
  ConvexPolygon<float> b;
  Pose<float> b_in_a;
};

Pair pair_of(const Regime& regime, std::uint64_t index) {
  const PairCase pair = generate(6, regime, index);
  return {pair.a.polygon, pair.b.polygon, relative_pose(pair.a.pose, pair.b.pose)};
}

/// The greatest separation of both polygons' faces, by the clean code.
float separation_of(const Pair& pair) {
  const ConvexPolygon<float> b = transform(pair.b_in_a, pair.b);
  constexpr float none = std::numeric_limits<float>::infinity();
  return std::max(clipping::greatest_separation(pair.a, b, none).separation,
                  clipping::greatest_separation(b, pair.a, none).separation);
}

/// Whether no face separates sharp polygons, whether round shapes have a contact.
bool touch(const Pair& pair) {
  if (are_round(pair.a, pair.b)) return clipping::collide(pair.a, pair.b, pair.b_in_a).count > 0;
  return !(separation_of(pair) > pair.a.radius + pair.b.radius);
}

/// How many queries about this pair, with the hint, are wrong.
int mistakes(const Pair& pair, float tie_bias, kernel::FaceHint hint) {
  const auto& [a, b, b_in_a] = pair;
  const kernel::ShapeRows rows_a = kernel::rows_of(a);
  const kernel::ShapeRows rows_b = kernel::rows_of(b);
  kernel::FaceHint for_touches = hint;
  kernel::FaceHint for_separation = hint;
  kernel::FaceHint for_manifold = hint;
  int wrong = 0;
  wrong += kernel::collide(rows_a, rows_b, b_in_a, tie_bias, &for_manifold) !=
           clipping::collide(a, b, b_in_a, tie_bias);
  wrong += kernel::touches(rows_a, rows_b, b_in_a, &for_touches) != touch(pair);
  const auto found = kernel::separation(rows_a, rows_b, b_in_a, &for_separation);
  wrong += found.touches != touch(pair);
  if (found.touches && are_round(a, b)) {
    wrong += !(found.separation <= a.radius + b.radius);
  } else if (found.touches) {
    wrong += found.separation != separation_of(pair);
  } else {
    wrong += !(found.separation > a.radius + b.radius);
  }
  return wrong;
}

}  // namespace

TEST_CASE("pair equals clip bit for bit on every target, in every regime, whatever the hint") {
  for (const auto& regimes : {polygon_regimes(), round_regimes()}) {
    for (const Regime& regime : regimes) {
      INFO(regime.name);
      on_every_target([&] {
        int wrong = 0;
        for (std::uint64_t i = 0; i < kCases; ++i) {
          const Pair pair = pair_of(regime, i);
          const auto side = i % 2 == 0 ? Side::a : Side::b;
          wrong += mistakes(pair, 0, {});
          wrong += mistakes(pair, 0.0005F, {side, static_cast<int>(i % kMaxVertices)});
        }
        CHECK(wrong == 0);
      });
    }
  }
}

namespace {

/// A manifold whose numbers that are none are one and the same.
Manifold<float> with_one_nan(Manifold<float> m) {
  for (ContactPoint<float>& point : m.points) {
    for (float* const number : {&point.position.x(), &point.position.y(), &point.depth}) {
      if (std::isnan(*number)) *number = std::numeric_limits<float>::quiet_NaN();
    }
  }
  return m;
}

/// Equal to the last bit, but that one NaN is as good as another.
bool same_numbers(const Manifold<float>& m, const Manifold<float>& n) {
  return m.count == 0 ? n.count == 0 : same_bits(with_one_nan(m), with_one_nan(n));
}

Manifold<float> by_kernel(const Pair& pair) {
  return kernel::collide(kernel::rows_of(pair.a), kernel::rows_of(pair.b), pair.b_in_a);
}

/// A pair of the regime with all lengths times as much as makes its largest coordinate this one.
Pair scaled_pair(const Regime& regime, std::uint64_t index, float largest) {
  Pair pair = pair_of(regime, index);
  float reach = 0;
  for (const auto* shape : {&pair.a, &pair.b}) {
    for (const auto& v : shape->corners()) reach = std::max(reach, v.cwiseAbs().maxCoeff());
  }
  const float factor = largest / reach;
  for (auto* shape : {&pair.a, &pair.b}) {
    for (auto& v : shape->vertices) v *= factor;
    shape->radius *= factor;
  }
  pair.b_in_a.position *= factor;
  return pair;
}

/// On how many pairs of all regimes, of this largest coordinate, the kernel and `clip` differ.
int differing(float largest) {
  int differ = 0;
  for (const Regime& regime : polygon_regimes()) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      const Pair pair = scaled_pair(regime, i, largest);
      differ += !same_numbers(by_kernel(pair), clipping::collide(pair.a, pair.b, pair.b_in_a));
    }
  }
  return differ;
}

}  // namespace

TEST_CASE("pair equals clip where offsets and depths overflow, or are no numbers") {
  for (const float largest : {3e38F, 1e38F, 3e37F, 1e19F}) {
    CAPTURE(largest);
    on_every_target([&] { CHECK(differing(largest) == 0); });
  }
}

TEST_CASE("pair equals clip of tiny shapes, where what is subnormal is taken for zero, too") {
  for (const bool is_flushed : {false, true}) {
    const FlushToZero flushing(is_flushed && can_flush_to_zero());
    for (const float largest : {1e-36F, 3e-37F, 1e-37F, 3e-38F}) {
      CAPTURE(is_flushed, largest);
      on_every_target([&] { CHECK(differing(largest) == 0); });
    }
  }
}

TEST_CASE("pair equals clip to the sign of zero, where a radius is -0") {
  const std::vector<Vector2<float>> corners{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  auto square = make_polygon<float>(corners);
  square.radius = -0.0F;
  const Pair pair{square, square, {{0, 2}, {1, 0}}};
  const Manifold<float> expected = clipping::collide(pair.a, pair.b, pair.b_in_a);
  REQUIRE(expected.count == 2);
  CHECK(std::signbit(expected.points[0].depth));
  on_every_target([&] { CHECK(same_bits(by_kernel(pair), expected)); });
}

namespace {

/// Two polygons and the hints that queries about them have left.
struct Hints {
  kernel::FaceHint touches;
  kernel::FaceHint separation;
  kernel::FaceHint manifold;
};
using Model = Pair;
using Command = rc::state::Command<Model, Hints>;

Vector2<float> unit(std::uint64_t seed) {
  Random random(seed, "motion", 0);
  const double t = 2 * random.unit() - 1;
  const double over = 1 + t * t;
  return Vector2<double>((1 - t * t) / over, 2 * t / over).cast<float>();
}

struct Move : Command {
  std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
  void apply(Model& model) const override {
    Random random(seed, "motion", 0);
    const auto step = [&] { return static_cast<float>(0.2 * random.unit() - 0.1); };
    model.b_in_a.position += Vector2<float>(step(), step());
  }
  void show(std::ostream& out) const override { out << "move " << seed; }
};

struct Spin : Command {
  std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
  void apply(Model& model) const override { model.b_in_a.rotation = unit(seed); }
  void show(std::ostream& out) const override { out << "spin " << seed; }
};

/// Other polygons far from where these were: the hints are stale.
struct Teleport : Command {
  std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
  void apply(Model& model) const override {
    const auto all = polygon_regimes();
    model = pair_of(all[seed % all.size()], seed % 1000);
  }
  void show(std::ostream& out) const override { out << "teleport " << seed; }
};

struct Query : Command {
  void apply(Model&) const override {}
  void run(const Model& model, Hints& hints) const override {
    const kernel::ShapeRows a = kernel::rows_of(model.a);
    const kernel::ShapeRows b = kernel::rows_of(model.b);
    const Pose<float>& b_in_a = model.b_in_a;
    RC_ASSERT(kernel::touches(a, b, b_in_a, &hints.touches) == touch(model));
    const auto found = kernel::separation(a, b, b_in_a, &hints.separation);
    RC_ASSERT(found.touches == touch(model));
    RC_ASSERT(!found.touches || found.separation == separation_of(model));
    RC_ASSERT(kernel::collide(a, b, b_in_a, 0, &hints.manifold) == kernel::collide(a, b, b_in_a));
  }
  void show(std::ostream& out) const override { out << "query"; }
};

}  // namespace

TEST_CASE("a hint changes neither whether two polygons touch nor their manifold") {
  CHECK(rc::check("queries with hints, between motions", [] {
    const Model model = pair_of(*find_regime("generic"), 0);
    Hints hints;
    rc::state::check(model, hints,
                     rc::state::gen::execOneOfWithArgs<Move, Move, Spin, Teleport, Query, Query>());
  }));
}
