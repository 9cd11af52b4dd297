// Sweeps that come near to where a decision turns, in steps of an ulp at 1.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/ulps.hpp"
#include "generating/sweep_drafts.hpp"
#include "generating/sweep_list.hpp"
#include "generating/ties.hpp"

namespace manifuzz::turn {
namespace {

constexpr double kUlp = 0x1p-23;
constexpr double kAccuracy = 0.05 * kUlp;

/// The greatest separation of one side's faces, with B at p from A.
double greatest(const Faces& faces, Side side, const Vector2<double>& p) {
  double separation = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < faces.count; ++k) {
    if (faces.side(k) == side) separation = std::max(separation, faces.separation(k, p));
  }
  return separation;
}

/// A's face and B's that separate alike, but for B's lead.
std::optional<PairCase> tied_sides(Random& random, double lead) {
  const Outline a = benign_outline(random);
  const Outline b = benign_outline(random);
  Draft draft = any_meeting(random, a, b);
  draft.gap = -random.uniform(0.001, 0.1) * span(draft);
  draft.world.rotation = random_direction(random);
  auto pair = settle(draft);
  if (!pair) return std::nullopt;
  const auto tie = find_tie(*pair, random.either_sign(1));
  if (!tie) return std::nullopt;
  const auto place = [&](const Faces& faces) { return place_at(faces, *tie, lead); };
  if (!place_exactly(*pair, place)) return std::nullopt;
  const Faces placed = faces_of(*pair);
  const Vector2<double> at = apart(*pair);
  const double off = greatest(placed, Side::b, at) - greatest(placed, Side::a, at) - lead;
  return std::abs(off) < kAccuracy ? pair : std::nullopt;
}

/// B's corner points straight at A's face, but for `tilt`: the edges on both sides of it tie. B is
/// mirror-symmetric to the last bit, and nothing may move its vertices.
std::optional<PairCase> tied_edges(Random& random, double tilt) {
  const Outline a = benign_outline(random);
  Draft draft;
  const Outline up = face_up(a, random.integer(0, a.count - 1), random.uniform(0.2, 0.8));
  draft.a.outline = turned(up, unit({1, tilt}));
  const double scale = random.magnitude(-1, 0);
  const Outline b = moved(regular_outline(random_count(random)), {0, -1});
  draft.b.outline = upside_down(stretched(b, scale, scale));
  draft.gap = -random.uniform(0.001, 0.1) * span(draft);
  stand_near(random, draft);
  draft.exact_gap = false;
  return settle(maybe_swapped(random, draft));
}

}  // namespace

std::optional<PairCase> tie(Random& random, double value) {
  constexpr double box2d_bias = 0.0005;
  const double off = random.either_sign(value * kUlp);
  switch (random.integer(0, 2)) {
    case 0:
      return tied_sides(random, off);
    case 1:
      return tied_sides(random, box2d_bias + off);
    default:
      return tied_edges(random, off);
  }
}

std::optional<PairCase> touch(Random& random, double value) {
  const Outline a = benign_outline(random);
  const Outline b = benign_outline(random);
  Draft draft = any_meeting(random, a, b);
  give_own_axes(random, draft.a);
  give_own_axes(random, draft.b);
  if (random.chance(0.25)) draft.radius_a = draft.radius_b = 0.01F;
  draft.gap = random.either_sign(value * kUlp);
  stand_near(random, draft);
  auto pair = settle(draft);
  if (!pair) return std::nullopt;
  const double target = total_radius(*pair) + *draft.gap;
  Vector2<double> start = apart(*pair);
  const auto place = [&](const Faces& faces) {
    const Vector2<double> from = std::exchange(start, {0, 0});
    return slide(faces, from, rotate(draft.world.rotation, draft.direction), target);
  };
  if (!place_exactly(*pair, place)) return std::nullopt;
  const double off = separation(faces_of(*pair), apart(*pair)) - target;
  return std::abs(off) < kAccuracy ? pair : std::nullopt;
}

std::optional<PairCase> corner(Random& random, double value) {
  const auto face_from_origin = [&] {
    const Outline outline = benign_outline(random);
    const int face = random.integer(0, outline.count - 1);
    return face_up(outline, face, random.chance(0.5) ? 0 : 1);
  };
  Draft draft;
  draft.a.outline = face_from_origin();
  const double tilt = random.uniform(-0.1, 0.1);
  draft.b.outline = turned(upside_down(face_from_origin()), unit({1, tilt}));
  draft.start.x() = random.either_sign(value * kUlp);
  draft.gap = -random.uniform(0, 0.05) * span(draft);
  stand_near(random, draft);
  return settle(maybe_swapped(random, draft));
}

}  // namespace manifuzz::turn
