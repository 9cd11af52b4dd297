#include <cmath>

#include "base/random.hpp"
#include "generating/drafts.hpp"
#include "generating/regime.hpp"
#include "generating/solids.hpp"

namespace manifuzz::draw {

// Regimes of round shapes. The drawing has A below and B above: the nearest places of both cores
// lie on the y axis, so far apart as the radii and the gap say.

namespace {

/// The total radius, that of polygons as the context may have it.
double radii(const GenerationContext& context, const Solid& a, const Solid& b) {
  double sum = 0;
  for (const Solid* const solid : {&a, &b}) {
    const bool is_given = context.radius && solid->outline.count >= kMinVertices;
    sum += is_given ? static_cast<double>(*context.radius) : solid->radius;
  }
  return sum;
}

/// The draft with B moved up by `distance`, and the solids' radii; stood somewhere.
bool stood(Random& random, Draft draft, const Solid& a, const Solid& b, double distance,
           PairCase& pair) {
  set_apart(draft, a, b, distance);
  const double far = random.chance(0.3) ? 5 * std::max(size_of(a), size_of(b)) : 0;
  frame(random, draft);
  if (far > 0) {
    const double x = random.uniform(-far, far);
    const double y = random.uniform(-far, far);
    draft.world.position += Vector2<double>(x, y);
  }
  return settle(maybe_swapped(random, draft), pair);
}

/// Touching or nearly, by a share of the smaller solid's size.
bool met(Random& random, const GenerationContext& context, const Draft& draft, const Solid& a,
         const Solid& b, PairCase& pair) {
  const double gap = draw_gap(random) * std::min(size_of(a), size_of(b));
  return stood(random, draft, a, b, radii(context, a, b) + gap, pair);
}

bool met(Random& random, const GenerationContext& context, const Solid& a, const Solid& b,
         PairCase& pair) {
  const Outline below = place_up(random, a.outline);
  const Outline above = place_up(random, b.outline);
  return met(random, context, facing(below, above), a, b, pair);
}

/// Next to nothing, of either sign, or nothing.
double next_to_nothing(Random& random) {
  return random.chance(0.3) ? 0 : random.either_sign(random.magnitude(-30, -6));
}

}  // namespace

bool circles(Random& random, const GenerationContext& context, PairCase& pair) {
  const Solid a = draw_solid(random, Family::circle);
  const Solid b = any_of(random, {Family::circle, Family::polygon, Family::rounded});
  return met(random, context, a, b, pair);
}

bool capsules(Random& random, const GenerationContext& context, PairCase& pair) {
  const Solid a = any_of(random, {Family::segment, Family::capsule, Family::capsule});
  const Solid b =
      any_of(random, {Family::capsule, Family::capsule, Family::circle, Family::polygon});
  return met(random, context, a, b, pair);
}

bool round_corners(Random& random, const GenerationContext& context, PairCase& pair) {
  const Solid a = draw_solid(random, Family::rounded);
  const Solid b = any_of(random, {Family::rounded, Family::rounded, Family::polygon});
  return met(random, context, a, b, pair);
}

bool mixed_shapes(Random& random, const GenerationContext& context, PairCase& pair) {
  const auto all = {Family::circle, Family::segment, Family::capsule, Family::rounded,
                    Family::polygon};
  const Solid a =
      any_of(random, {Family::circle, Family::segment, Family::capsule, Family::rounded});
  const Solid b = any_of(random, all);
  return met(random, context, a, b, pair);
}

bool in_line(Random& random, const GenerationContext& context, PairCase& pair) {
  const Solid a = any_of(random, {Family::segment, Family::capsule, Family::capsule});
  const Solid b = any_of(random, {Family::capsule, Family::capsule, Family::circle});
  if (b.outline.count == 1 || random.chance(0.5)) {
    // End to end; one of them leans off the line by next to nothing.
    const Outline below = end_up(span(a.outline), next_to_nothing(random));
    return met(random, context,
               facing(below, b.outline.count == 1 ? b.outline : end_up(span(b.outline), 0)), a, b,
               pair);
  }
  // On each other, or across: a point of one is on a point of the other.
  const Outline below = face_up(a.outline, 0, random.uniform(0, 1));
  const Outline above = face_up(b.outline, 0, random.uniform(0, 1));
  Draft draft = facing(below, above);
  const double kind = random.unit();
  if (kind < 0.5) draft.b.pose.rotation = random_direction(random);
  if (kind >= 0.5 && kind < 0.8) draft.b.pose.rotation = unit({1, next_to_nothing(random)});
  const double off = next_to_nothing(random) * std::min(size_of(a), size_of(b));
  return stood(random, draft, a, b, off, pair);
}

bool tilted_edges(Random& random, const GenerationContext& context, PairCase& pair) {
  const Solid a = any_of(random, {Family::capsule, Family::segment, Family::rounded});
  const Solid b = any_of(random, {Family::capsule, Family::capsule, Family::rounded});
  // Engines give a second point within an angle of their own: dyn4j's has the cosine 0.98, parry's
  // is a quarter of a right angle.
  constexpr double tangents[] = {0, 0.20305866063400677, 0.41421356237309503};
  const int angle = random.integer(0, 2);
  double tilt = random.either_sign(tangents[angle]);
  tilt += random.chance(0.3) ? 0 : random.either_sign(random.magnitude(-30, -3));
  const int face_a = random.integer(0, a.outline.count - 1);
  const Outline below = face_up(a.outline, face_a, random.uniform(0.05, 0.95));
  const int face_b = random.integer(0, b.outline.count - 1);
  const Outline above = face_up(b.outline, face_b, random.uniform(0.05, 0.95));
  Draft draft = facing(below, turned(above, unit({1, tilt})));
  double lowest = 0;
  for (int i = 0; i < draft.b.outline.count; ++i) {
    lowest = std::min(lowest, draft.b.outline.vertices[i].y());
  }
  draft.start.y() -= lowest;
  return met(random, context, draft, a, b, pair);
}

bool voronoi_lines(Random& random, const GenerationContext& context, PairCase& pair) {
  const Solid a =
      any_of(random, {Family::segment, Family::capsule, Family::rounded, Family::polygon});
  const Solid b = any_of(random, {Family::circle, Family::circle, Family::capsule});
  const double off = next_to_nothing(random);
  Outline below;
  if (a.outline.count == 2) {
    const double upright = std::sqrt(1 - off * off);
    below = {.vertices = {{{0, 0}, span(a.outline) * Vector2<double>(upright, off)}}, .count = 2};
  } else {
    const int corner = random.integer(0, a.outline.count - 1);
    below = corner_up(a.outline, corner, random.chance(0.5) ? off : 1 - off);
  }
  const Outline above =
      b.outline.count == 1 ? b.outline : end_up(span(b.outline), random.uniform(-0.9, 0.9));
  return met(random, context, facing(below, above), a, b, pair);
}

bool cores_touch(Random& random, const GenerationContext&, PairCase& pair) {
  const auto all = {Family::circle, Family::segment, Family::capsule, Family::rounded};
  const Solid a = any_of(random, all);
  const Solid b = any_of(random, {Family::circle, Family::capsule, Family::rounded});
  if (random.chance(0.15)) {
    // A shape upon itself, or nearly.
    Draft draft;
    draft.a.outline = draft.b.outline = b.outline;
    if (random.chance(0.5)) draft.b.pose.rotation = unit({1, next_to_nothing(random)});
    return stood(random, draft, b, b, next_to_nothing(random) * size_of(b), pair);
  }
  const Outline below = place_up(random, a.outline);
  const Outline above = place_up(random, b.outline);
  const double size = std::min(size_of(a), size_of(b));
  const double distance =
      random.chance(0.2)
          ? 0
          : size * (random.chance(0.7) ? random.magnitude(-40, -3) : -random.magnitude(-30, -6));
  return stood(random, facing(below, above), a, b, distance, pair);
}

bool large_radii(Random& random, const GenerationContext& context, PairCase& pair) {
  Solid a = any_of(random, {Family::segment, Family::capsule, Family::rounded});
  Solid b = any_of(random, {Family::circle, Family::capsule, Family::rounded});
  for (Solid* const solid : {&a, &b}) {
    solid->radius = random.magnitude(-1, 1);
    const double scale = random.magnitude(-14, -2);
    solid->outline = stretched(solid->outline, scale, scale);
  }
  return met(random, context, a, b, pair);
}

bool side_planes(Random& random, const GenerationContext& context, PairCase& pair) {
  const Solid a = any_of(random, {Family::capsule, Family::segment, Family::rounded});
  const Solid b = any_of(random, {Family::capsule, Family::capsule, Family::rounded});
  // The edges face each other, and the first end of one is in front of the last of the other.
  const int face_a = random.integer(0, a.outline.count - 1);
  const int face_b = random.integer(0, b.outline.count - 1);
  Draft draft = facing(face_up(a.outline, face_a, 0), face_up(b.outline, face_b, 1));
  if (random.chance(0.3)) draft = facing(draft.a.outline, face_up(b.outline, face_b, 0));
  draft.start.x() = next_to_nothing(random) * std::min(size_of(a), size_of(b));
  return met(random, context, draft, a, b, pair);
}

}  // namespace manifuzz::draw
