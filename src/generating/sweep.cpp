#include "generating/sweep.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace manifuzz {
namespace {

/// As far from unit as a valid rotation may be.
const std::vector<double> kOffUnitValues{1e-7, 1.2e-7, 1.5e-7, 2e-7,   2.5e-7, 3e-7,   4e-7,  5e-7,
                                         6e-7, 8e-7,   1e-6,   1.2e-6, 2e-6,   2.5e-6, 3e-6,  4e-6,
                                         5e-6, 6e-6,   7e-6,   8e-6,   9e-6,   9.5e-6, 9.8e-6};

double decimal(int mantissa, int exponent) {
  return std::stod(fmt::format("{}e{}", mantissa, exponent));
}

}  // namespace

std::span<const Sweep> sweeps() {
  static const std::vector<Sweep> all = {
#define MANIFUZZ_ENTRY(name, knob, unit, values, description) \
  {#name, description, knob, unit, values, turn::name},
      MANIFUZZ_SWEEPS(MANIFUZZ_ENTRY)
#undef MANIFUZZ_ENTRY
#define MANIFUZZ_ENTRY(name, knob, unit, values, description) \
  {#name, description, knob, unit, values, turn::name, true},
          MANIFUZZ_ROUND_SWEEPS(MANIFUZZ_ENTRY)
#undef MANIFUZZ_ENTRY
  };
  return all;
}

PairCase draw_case(std::uint64_t seed, const Sweep& sweep, double value, std::uint64_t index) {
  constexpr int attempts = 1000;
  Random random(mix(seed) ^ std::bit_cast<std::uint64_t>(value), sweep.name, index);
  PairCase pair;
  for (int i = 0; i < attempts; ++i) {
    if (sweep.attempt(random, value, pair)) return pair;
  }
  throw std::logic_error(fmt::format("sweep {} draws nothing at {}", sweep.name, value));
}

std::vector<double> decades(std::initializer_list<int> mantissas, int from, int to) {
  const bool rises = from < to;
  std::vector<double> values;
  for (int exponent = from; exponent != to; exponent += rises ? 1 : -1) {
    for (const int mantissa : mantissas) {
      values.push_back(decimal(mantissa, rises ? exponent : exponent - 1));
    }
  }
  values.push_back(decimal(1, to));
  return values;
}

std::vector<double> powers_of_two_to_zero(int from) {
  std::vector<double> values;
  for (int exponent = from; exponent >= 0; --exponent) values.push_back(std::ldexp(1.0, exponent));
  values.push_back(0);
  return values;
}

Outline benign_outline(Random& random, int most) {
  const Outline regular =
      turned(regular_outline(random_count(random, most)), random_direction(random));
  const double scale = random.magnitude(-1, 0);
  const double flat = random.uniform(0.7, 1.4);
  return turned(stretched(regular, scale, scale * flat), random_direction(random));
}

void give_own_axes(Random& random, Sketch& sketch) {
  const Vector2<double> axes = random_direction(random);
  sketch.outline = turned(sketch.outline, {axes.x(), -axes.y()});
  sketch.pose.rotation = rotate(sketch.pose.rotation, axes);
}

void meet(Random& random, Draft& draft, double unit) {
  if (random.chance(0.25)) {
    draft.radius_a = draft.radius_b = static_cast<float>(0.01 * span(draft));
  }
  draft.gap = draw_gap(random) * unit;
}

void stand_near(Random& random, Draft& draft) {
  draft.world.rotation = random_direction(random);
  const double far = 2 * span(draft);
  const double x = random.uniform(-far, far);
  const double y = random.uniform(-far, far);
  // A float, so that A stands where the drawing has it.
  draft.world.position = Vector2<double>(x, y).cast<float>().cast<double>();
  draft.exact_gap = true;
}

namespace {

constexpr std::array kWalks{
    Walk{.name = "resting",
         .description = "a random walk: a box rests on a box, and trembles",
         .gap_low = -0.01,
         .gap_high = -0.001,
         .gap_step = 1e-5,
         .aside_max = 0.8,
         .aside_step = 1e-5,
         .tilt_max = 1e-5,
         .tilt_step = 1e-6},
    Walk{.name = "sliding",
         .description = "a random walk: a hexagon slides over a box and past its corners",
         .count_b = 6,
         .gap_low = -0.02,
         .gap_high = 0.002,
         .gap_step = 1e-3,
         .aside_max = 1.5,
         .aside_step = 1e-2,
         .tilt_max = 0.05,
         .tilt_step = 1e-3},
    Walk{.name = "tumbling",
         .description = "a random walk: a triangle tumbles all round a pentagon",
         .count_a = 5,
         .count_b = 3,
         .gap_low = -0.05,
         .gap_high = 0.002,
         .gap_step = 1e-3,
         .turn_step = 2e-2},
};

/// A regular polygon, a face of it up; boxes twice as wide as high.
Outline outline_of(int count) {
  if (count == 4) return box(1, 0.5);
  return face_up(regular_outline(count), 0, 0.5);
}

Body body_of(const Outline& outline, const Pose<double>& pose) {
  return {*rounded(outline, 0), {pose.position.cast<float>(), pose.rotation.cast<float>()}};
}

}  // namespace

std::span<const Walk> walks() {
  return kWalks;
}

Walker::Walker(std::uint64_t seed, const Walk& walk)
    : walk_(walk), random_(seed, walk.name, 0), rotation_a_(random_direction(random_)) {
  gap_ = (walk.gap_low + walk.gap_high) / 2;
  Pose<double> pose;
  const double x = random_.uniform(-2, 2);
  const double y = random_.uniform(-2, 2);
  pose.position = {x, y};
  pose.rotation = rotation_a_;
  pair_.a = body_of(outline_of(walk.count_a), pose);
  pair_.b = body_of(upside_down(outline_of(walk.count_b)), pose);
}

double Walker::moved(double at, double step, double low, double high) {
  const double to = at + random_.uniform(-step, step);
  if (to < low) return 2 * low - to;
  return to > high ? 2 * high - to : to;
}

PairCase Walker::next() {
  gap_ = moved(gap_, walk_.gap_step, walk_.gap_low, walk_.gap_high);
  aside_ = moved(aside_, walk_.aside_step, -walk_.aside_max, walk_.aside_max);
  tilt_ = moved(tilt_, walk_.tilt_step, -walk_.tilt_max, walk_.tilt_max);
  const double turn = random_.uniform(-walk_.turn_step, walk_.turn_step);
  const double way = random_.uniform(-walk_.turn_step, walk_.turn_step);
  turn_ = unit(rotate<double>(turn_, {1, turn}));
  heading_ = unit(rotate<double>(heading_, {1, way}));
  const Vector2<double> turned = rotate(turn_, unit({1, tilt_}));
  pair_.b.pose.rotation = rotate(rotation_a_, turned).cast<float>();
  const Vector2<double> start = rotate<double>(rotation_a_, {aside_, 0});
  const Vector2<double> direction = rotate(rotation_a_, heading_);
  put_apart(pair_, slide(pair_, start, direction, gap_));
  return pair_;
}

PairCase frame_of(std::uint64_t seed, const Walk& walk, std::uint64_t index) {
  Walker walker(seed, walk);
  for (std::uint64_t i = 0; i < index; ++i) walker.next();
  return walker.next();
}

}  // namespace manifuzz
