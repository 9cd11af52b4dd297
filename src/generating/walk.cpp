#include "generating/walk.hpp"

#include <algorithm>
#include <array>

namespace manifuzz {
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

const Walk* find_walk(std::string_view name) {
  const auto* const found = std::ranges::find(kWalks, name, &Walk::name);
  return found == kWalks.end() ? nullptr : found;
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
  put_apart(pair_, slide(faces_of(pair_), start, direction, gap_));
  return pair_;
}

PairCase frame_of(std::uint64_t seed, const Walk& walk, std::uint64_t index) {
  Walker walker(seed, walk);
  for (std::uint64_t i = 0; i < index; ++i) walker.next();
  return walker.next();
}

}  // namespace manifuzz
