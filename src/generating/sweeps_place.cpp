// Sweeps named for where the polygons are and how large.

#include <algorithm>
#include <cmath>

#include "generating/sweep_drafts.hpp"
#include "generating/sweep_list.hpp"

namespace manifuzz::turn {
namespace {

double diameter(const Outline& outline) {
  double squared = 0;
  for (int i = 0; i < outline.count; ++i) {
    for (int j = 0; j < i; ++j) {
      const Vector2<double> apart = outline.vertices[i] - outline.vertices[j];
      squared = std::max(squared, apart.dot(apart));
    }
  }
  return std::sqrt(squared);
}

/// Two outlines in any meeting, each with axes of its own.
Draft met(Random& random, const Outline& a, const Outline& b) {
  Draft draft = any_meeting(random, a, b);
  give_own_axes(random, draft.a);
  give_own_axes(random, draft.b);
  return draft;
}

Draft benign_pair(Random& random, double scale_a, double scale_b) {
  const Outline a = stretched(benign_outline(random), scale_a, scale_a);
  const Outline b = stretched(benign_outline(random), scale_b, scale_b);
  return met(random, a, b);
}

std::optional<PairCase> sized(Random& random, double scale) {
  Draft draft = benign_pair(random, scale, scale);
  meet(random, draft);
  stand_near(random, draft);
  return settle(draft);
}

}  // namespace

std::optional<PairCase> distance(Random& random, double value) {
  Draft draft = benign_pair(random, 1, 1);
  meet(random, draft);
  stand_near(random, draft);
  draft.world.position = value * random_direction(random);
  return settle(draft);
}

std::optional<PairCase> small(Random& random, double value) {
  return sized(random, value);
}

std::optional<PairCase> large(Random& random, double value) {
  return sized(random, value);
}

std::optional<PairCase> ratio(Random& random, double value) {
  const Outline large = benign_outline(random);
  const Outline regular = benign_outline(random);
  const double scale = diameter(large) / (value * diameter(regular));
  Draft draft = met(random, large, stretched(regular, scale, scale));
  meet(random, draft);
  stand_near(random, draft);
  return settle(maybe_swapped(random, draft));
}

std::optional<PairCase> depth(Random& random, double value) {
  constexpr double roomy = 10;  // deep enough for all of B
  Draft draft = benign_pair(random, roomy, 1);
  draft.gap = -value * std::min(diameter(draft.a.outline), diameter(draft.b.outline));
  stand_near(random, draft);
  draft = maybe_swapped(random, draft);
  const auto pair = settle(draft);
  if (!pair || gap_error(*pair, *draft.gap) > 0.01) return std::nullopt;
  return pair;
}

std::optional<PairCase> off_unit(Random& random, double value) {
  Draft draft = benign_pair(random, 1, 1);
  meet(random, draft);
  stand_near(random, draft);
  for (Sketch* sketch : {&draft.a, &draft.b}) put_off_unit(*sketch, random.either_sign(value));
  return settle(draft);
}

}  // namespace manifuzz::turn
