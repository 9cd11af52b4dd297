#include <cmath>

#include <catch2/catch.hpp>

#include "sequence/motions.hpp"
#include "unit/methods/kept.hpp"
#include "unit/methods/placed.hpp"

// Moving both bodies together, in each frame by another motion, changes nothing of what is kept.

using namespace manifuzz;
using namespace manifuzz::methods;

namespace {

/// A motion of both that rounds nothing: some quarter turns, and a power of two along each axis.
struct ExactMotion {
  int quarters = 0;
  Vector2<float> step{0, 0};

  Vector2<float> turn(Vector2<float> v) const {
    for (int i = 0; i < quarters; ++i) v = counter_clockwise_quarter(v);
    return v;
  }
  Pose<float> of(const Pose<float>& pose) const {
    return {turn(pose.position) + step, turn(pose.rotation)};
  }
};

ExactMotion any_exact_motion() {
  const auto step = [] {
    const int exponent = *rc::gen::inRange(-6, 3);
    return static_cast<float>(*rc::gen::elementOf(std::vector{-1, 0, 1})) *
           std::ldexp(1.0F, exponent);
  };
  const float x = step();
  return {*rc::gen::inRange(0, 4), {x, step()}};
}

/// On a grid so coarse that adding any such step to it is exact, up to 60 from the origin.
Vector2<float> on_grid(const Vector2<float>& place) {
  constexpr float grid = 0x1p-17F;
  return {std::round(place.x() / grid) * grid, std::round(place.y() / grid) * grid};
}

/// A sequence of shapes of about a unit, A at the origin.
Sequence any_sequence() {
  const auto name = *rc::gen::elementOf(
      std::vector<std::string>{"resting", "rocking", "sliding", "rolling", "apart_and_back"});
  Sequence sequence = draw_sequence(*rc::gen::arbitrary<std::uint64_t>(), *find_motion(name), 0);
  for (FramePoses& poses : sequence.frames) {
    poses.b.position = on_grid(poses.b.position - poses.a.position);
    poses.a.position = {0, 0};
  }
  return sequence;
}

/// What is kept in the moved frame is what was kept, its normal turned as both bodies are.
void check_same(const std::vector<KeptPoint>& kept, const std::vector<KeptPoint>& moved,
                const ExactMotion& motion) {
  RC_ASSERT(kept.size() == moved.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    KeptPoint expected = kept[i];
    for (int k = 0; k < motion.quarters; ++k) {
      expected.normal = counter_clockwise_quarter(expected.normal);
    }
    RC_ASSERT(moved[i] == expected);
  }
}

void check_exactly(const SequenceCollider& collider) {
  const std::string name = collider.declaration.name;
  const bool holds = rc::check("moving both changes nothing of what is kept: " + name, [&] {
    const Sequence sequence = any_sequence();
    const auto ask = collider.begin();
    const auto ask_moved = collider.begin();
    std::size_t most = 0;
    for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
      const PairCase frame = sequence.at(i);
      const ExactMotion motion = any_exact_motion();
      PairCase moved = frame;
      moved.a.pose = motion.of(frame.a.pose);
      moved.b.pose = motion.of(frame.b.pose);
      const auto kept = std::get<KeptManifold>(ask(frame)).points;
      check_same(kept, std::get<KeptManifold>(ask_moved(moved)).points, motion);
      most = std::max(most, kept.size());
    }
    RC_CLASSIFY(most > 0, "touching");
    RC_CLASSIFY(most > 1, "several points");
  });
  CHECK(holds);
}

}  // namespace

TEST_CASE("quarter turns and steps by powers of two change nothing of what is kept") {
  check_exactly(make_cached());
  check_exactly(make_cached64());
}

namespace {

/// From a rational point of the circle, unit but for 4 roundoffs: of the sums and the quotients.
Vector2<double> any_rotation(double most) {
  const double t = most * *rc::gen::inRange(-1000, 1001) / 1000;
  return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

Vector2<double> any_place(double most) {
  const double x = most * *rc::gen::inRange(-1000, 1001) / 999;
  return {x, most * *rc::gen::inRange(-1000, 1001) / 998};
}

std::optional<DetectedPoint<double>> any_detection() {
  if (*rc::gen::inRange(0, 3) == 0) return std::nullopt;
  const Vector2<double> normal = any_rotation(1);
  const Vector2<double> on_a = any_place(1);
  const double depth = 0.001 * *rc::gen::inRange(0, 200);
  const Side carrier = *rc::gen::elementOf(std::vector{Side::a, Side::b});
  return DetectedPoint<double>{normal, on_a, on_a - depth * normal, carrier};
}

Pose<double> moved(const Pose<double>& motion, const Pose<double>& pose) {
  return {transform(motion, pose.position), rotate(motion.rotation, pose.rotation)};
}

/// How far rounding of a motion may put a depth, in roundoffs. P is the farthest of both bodies
/// from the origin, before or after; E how far anchors are from their bodies, and those from each
/// other. Each place is off by 2.5 P for the turn and P for the sum, and so is the other one; with
/// the turn back, 2.5 for the product and 2.5 for A's rotation, of a distance of 2 P at most: 17 P.
/// The motion is unit but for 4, which the relative place has twice: 16 P. Rotations: 2.5 for each
/// of two and for their product, and 8: 16, of E. The same again at birth, and as far as 10 E for
/// what is done with it.
double roundoffs(double farthest, double extent) {
  return 2 * (33 * farthest + 16 * extent) + 10 * extent;
}

}  // namespace

TEST_CASE("any motion of both bodies changes what is kept by no more than rounding") {
  constexpr double u = 0x1p-53;
  const bool holds = rc::check("moving both changes depths by rounding alone", [&] {
    test::Kept kept;
    test::Kept kept_moved;
    kept.limits = kept_moved.limits = {0.2512345, 0.2512346, 0.2512347, 0.2512348};
    double farthest = 0;
    int most = 0;
    for (int frame = 0; frame < 6; ++frame) {
      const auto found = any_detection();
      const Pose<double> a{any_place(10), any_rotation(1)};
      const Pose<double> b = moved(a, {any_place(0.1), any_rotation(0.05)});
      const Pose<double> motion{any_place(1000), any_rotation(1)};
      const Pose<double> a_moved = moved(motion, a);
      const Pose<double> b_moved = moved(motion, b);
      kept.frame(relative_pose(a, b), found);
      kept_moved.frame(relative_pose(a_moved, b_moved), found);
      for (const Pose<double>& pose : {a, b, a_moved, b_moved}) {
        farthest = std::max(farthest, pose.position.norm());
      }
      RC_ASSERT(ids(kept) == ids(kept_moved));
      for (int i = 0; i < kept.cache.count; ++i) {
        const CachedPoint<double>& p = kept.cache.points[i];
        const CachedPoint<double>& q = kept_moved.cache.points[i];
        const double extent = p.anchor_a.norm() + p.anchor_b.norm() + 0.2;
        RC_ASSERT(p.born == q.born);
        RC_ASSERT(p.anchor_a == q.anchor_a);
        RC_ASSERT(std::abs(p.depth - q.depth) <= u * roundoffs(farthest, extent));
      }
      most = std::max(most, kept.cache.count);
    }
    RC_CLASSIFY(most > 1, "several points");
  });
  CHECK(holds);
}
