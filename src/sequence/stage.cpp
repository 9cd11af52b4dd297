#include "sequence/stage.hpp"

#include <algorithm>
#include <utility>

#include "generating/sweep.hpp"

namespace manifuzz {
namespace {

/// The outline in a frame of its own, which mostly is in its middle.
Sketch sketch_of(Random& random, const Outline& outline, Rounding rounding) {
  Vector2<double> origin = middle(outline);
  if (random.chance(0.2)) {
    const double x = random.uniform(-0.5, 0.5);
    const double y = random.uniform(-0.5, 0.5);
    origin += span(outline) * Vector2<double>(x, y);
  }
  Sketch sketch{moved(outline, -origin), {origin, {1, 0}}, rounding};
  give_own_axes(random, sketch);
  return sketch;
}

/// From where to where along x an outline touches y = 0, from above or from below.
std::pair<double, double> ends_of(const Outline& outline) {
  const double near = 1e-9 * span(outline);
  double left = 0;
  double right = 0;
  for (int i = 0; i < outline.count; ++i) {
    if (std::abs(outline.vertices[i].y()) > near) continue;
    left = std::min(left, outline.vertices[i].x());
    right = std::max(right, outline.vertices[i].x());
  }
  return {left, right};
}

Pose<double> moved(const Pose<double>& pose, const Move& move) {
  const Vector2<double> from_pivot = pose.position - move.about;
  return {move.about + rotate(move.turn, from_pivot) + move.by, rotate(move.turn, pose.rotation)};
}

Pose<double> as_double(const Pose<float>& pose) {
  return {pose.position.cast<double>(), pose.rotation.cast<double>()};
}

Pose<float> in_world(const Pose<double>& world, const Pose<double>& pose) {
  const Vector2<double> rotation = unit(rotate(world.rotation, pose.rotation));
  return {transform(world, pose.position).cast<float>(), rotation.cast<float>()};
}

}  // namespace

Solid any_solid(Random& random) {
  if (random.chance(0.5)) return draw_solid(random, Family::polygon);
  return any_of(random, {Family::circle, Family::segment, Family::capsule, Family::rounded});
}

Solid scaled(const Solid& solid, double scale) {
  return {stretched(solid.outline, scale, scale), scale * solid.radius, solid.rounding};
}

Outline side_up(Random& random, const Outline& outline) {
  if (outline.count == 1) return outline;
  const int face = random.integer(0, outline.count - 1);
  return face_up(outline, face, random.uniform(0.1, 0.9));
}

std::optional<Meeting> meeting_of(Random& random, const Solid& a, const Solid& b, double gap) {
  const Outline above = upside_down(b.outline);
  Draft draft;
  draft.a = sketch_of(random, a.outline, a.rounding);
  draft.b = sketch_of(random, above, b.rounding);
  const bool is_mitred = a.rounding == Rounding::mitre && b.rounding == Rounding::mitre;
  set_apart(draft, a, b, is_mitred ? 0 : a.radius + b.radius + gap);
  if (is_mitred) draft.gap = gap;
  PairCase pair;
  if (!settle(draft, pair)) return std::nullopt;
  const auto [left_a, right_a] = ends_of(a.outline);
  const auto [left_b, right_b] = ends_of(above);
  return Meeting{
      .a = pair.a.polygon,
      .b = pair.b.polygon,
      .at_a = as_double(pair.a.pose),
      .at_b = as_double(pair.b.pose),
      .size = std::min(size_of(a), size_of(b)),
      .height = static_cast<double>(pair.b.pose.position.y()) - draft.b.pose.position.y(),
      .left = std::max(left_a, left_b),
      .right = std::min(right_a, right_b)};
}

Stage::Stage(Random& random, const Meeting& meeting)
    : meeting_(meeting), world_(random_world(random, meeting.size)) {}

void Stage::carry(const Vector2<double>& turn, const Vector2<double>& by) {
  world_.rotation = unit(rotate(turn, world_.rotation));
  world_.position += by;
}

void Stage::show(const Move& a, const Move& b) {
  frames_.push_back(
      {in_world(world_, moved(meeting_.at_a, a)), in_world(world_, moved(meeting_.at_b, b))});
}

Sequence Stage::finished(Random& random) const {
  Sequence sequence{meeting_.a, meeting_.b, frames_};
  if (random.chance(0.5)) {
    std::swap(sequence.a, sequence.b);
    for (FramePoses& poses : sequence.frames) std::swap(poses.a, poses.b);
  }
  return sequence;
}

}  // namespace manifuzz
