#include "generating/solids.hpp"

#include <cmath>

namespace manifuzz {

Outline point() {
  return {.vertices = {{{0, 0}}}, .count = 1};
}

Outline segment(double length) {
  return {.vertices = {{{-length / 2, 0}, {length / 2, 0}}}, .count = 2};
}

Solid draw_solid(Random& random, Family family) {
  const double scale = random.magnitude(-2, 1);
  const double share = random.chance(0.8) ? random.uniform(0.05, 1) : random.magnitude(-12, -4);
  switch (family) {
    case Family::circle:
      return {point(), scale};
    case Family::segment:
      return {segment(2 * scale), 0};
    case Family::capsule:
      return {segment(2 * scale), share * scale};
    case Family::rounded:
      return {stretched(random_outline(random), scale, scale), share * scale / 2};
    default:
      return {stretched(random_outline(random), scale, scale), random.chance(0.7) ? 0 : 0.01,
              Rounding::mitre};
  }
}

Solid any_of(Random& random, std::initializer_list<Family> families) {
  const int last = static_cast<int>(families.size()) - 1;
  return draw_solid(random, families.begin()[random.integer(0, last)]);
}

double size_of(const Solid& solid) {
  return span(solid.outline) + 2 * solid.radius;
}

Outline end_up(double length, double lean) {
  const Vector2<double> axis{lean, -std::sqrt(1 - lean * lean)};
  return {.vertices = {{{0, 0}, length * axis}}, .count = 2};
}

Outline place_up(Random& random, const Outline& outline) {
  if (outline.count == 1) return outline;
  if (outline.count > 2) return face_or_corner_up(random, outline, 0.02);
  if (random.chance(0.5)) {
    const int face = random.integer(0, 1);
    return face_up(outline, face, random.uniform(0.02, 0.98));
  }
  return end_up(span(outline), random.uniform(-0.98, 0.98));
}

Draft facing(const Outline& a, const Outline& b) {
  Draft draft;
  draft.a.outline = a;
  draft.b.outline = upside_down(b);
  return draft;
}

void set_apart(Draft& draft, const Solid& a, const Solid& b, double distance) {
  draft.radius_a = static_cast<float>(a.radius);
  draft.radius_b = static_cast<float>(b.radius);
  draft.a.rounding = a.rounding;
  draft.b.rounding = b.rounding;
  draft.start.y() += distance;
}

}  // namespace manifuzz
