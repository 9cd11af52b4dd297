#include <algorithm>
#include <cmath>

#include "generating/drafts.hpp"
#include "generating/solids.hpp"
#include "generating/sweep.hpp"

namespace manifuzz::turn {

// Sweeps of round shapes.

namespace {

Solid benign_capsule(Random& random) {
  const double length = random.uniform(0.5, 2);
  return {segment(length), length * random.uniform(0.1, 0.5)};
}

Solid benign_circle(Random& random) {
  return {point(), random.uniform(0.25, 1)};
}

/// A capsule, and above it another or a circle, each turned as it comes.
struct FacingShapes {
  Solid a;
  Solid b;
  Draft draft;

  double size() const { return std::min(size_of(a), size_of(b)); }
};

FacingShapes facing_shapes(Random& random) {
  const Solid a = benign_capsule(random);
  const Solid b = random.chance(0.5) ? benign_capsule(random) : benign_circle(random);
  const Outline below = place_up(random, a.outline);
  const Outline above = place_up(random, b.outline);
  return {a, b, facing(below, above)};
}

/// Touching or nearly, by a share of the smaller solid's size, anywhere near the origin.
bool settled(Random& random, Draft draft, const Solid& a, const Solid& b, PairCase& pair,
             double more = 0) {
  const double size = std::min(size_of(a), size_of(b));
  const double radii = static_cast<double>(static_cast<float>(a.radius)) +
                       static_cast<double>(static_cast<float>(b.radius));
  set_apart(draft, a, b, radii + draw_gap(random) * size + more);
  give_own_axes(random, draft.a);
  give_own_axes(random, draft.b);
  stand_near(random, draft);
  return settle(maybe_swapped(random, draft), pair);
}

}  // namespace

bool capsule_angle(Random& random, double value, PairCase& pair) {
  const Solid a = benign_capsule(random);
  const Solid b = benign_capsule(random);
  const Outline below = face_up(a.outline, 0, random.uniform(0.1, 0.9));
  const Outline above = face_up(b.outline, 0, random.uniform(0.1, 0.9));
  const double tilt = random.either_sign(value);
  Draft draft = facing(below, turned(above, unit({1, tilt})));
  const double lowest = std::min(draft.b.outline.vertices[0].y(), draft.b.outline.vertices[1].y());
  return settled(random, draft, a, b, pair, -lowest);
}

bool roundness(Random& random, double value, PairCase& pair) {
  Solid a = benign_capsule(random);
  Solid b = random.chance(0.5) ? benign_capsule(random) : benign_circle(random);
  for (Solid* const solid : {&a, &b}) {
    const double scale = solid->radius / value;
    if (solid->outline.count > 1) solid->outline = segment(scale);
  }
  const Outline below = place_up(random, a.outline);
  const Outline above = place_up(random, b.outline);
  return settled(random, facing(below, above), a, b, pair);
}

bool core_distance(Random& random, double value, PairCase& pair) {
  FacingShapes drawn = facing_shapes(random);
  set_apart(drawn.draft, drawn.a, drawn.b, value * drawn.size());
  give_own_axes(random, drawn.draft.a);
  give_own_axes(random, drawn.draft.b);
  stand_near(random, drawn.draft);
  return settle(maybe_swapped(random, drawn.draft), pair);
}

bool round_distance(Random& random, double value, PairCase& pair) {
  FacingShapes drawn = facing_shapes(random);
  const double gap = draw_gap(random) * drawn.size();
  set_apart(drawn.draft, drawn.a, drawn.b, drawn.a.radius + drawn.b.radius + gap);
  drawn.draft.world = {value * random_direction(random), random_direction(random)};
  return settle(maybe_swapped(random, drawn.draft), pair);
}

}  // namespace manifuzz::turn
