// Regimes named for how the polygons meet.

#include "base/ulps.hpp"
#include "generating/drafts.hpp"
#include "generating/regime_list.hpp"

namespace manifuzz::draw {
namespace {

std::optional<PairCase> met(Random& random, const GenerationContext& context, Draft draft) {
  aim(random, context, draft);
  frame(random, draft);
  return settle(maybe_swapped(random, draft));
}

}  // namespace

std::optional<PairCase> near_parallel(Random& random, const GenerationContext& context) {
  const Outline a = sized_outline(random);
  const Outline b = sized_outline(random);
  const double tilt = random.chance(0.15) ? 0 : random.either_sign(random.magnitude(-30, -3));
  return met(random, context, face_to_face(random, a, b, tilt));
}

std::optional<PairCase> corner_face(Random& random, const GenerationContext& context) {
  const Outline a = sized_outline(random);
  const Outline b = sized_outline(random);
  return met(random, context, corner_to_face(random, a, b));
}

std::optional<PairCase> corner_corner(Random& random, const GenerationContext& context) {
  const Outline a = sized_outline(random);
  const Outline b = sized_outline(random);
  Draft draft = corner_to_corner(random, a, b);
  draw_radii(random, context, draft);
  const double kind = random.unit();
  const double gap = kind < 0.4   ? -random.magnitude(-24, -6)
                     : kind < 0.7 ? random.magnitude(-24, -4)
                                  : 0.098 * random.unit();
  draft.gap = gap * span(draft);
  if (random.chance(0.5)) {
    draft.start.x() = random.either_sign(random.magnitude(-24, -6)) * span(draft);
  }
  frame(random, draft);
  return settle(maybe_swapped(random, draft));
}

std::optional<PairCase> touching(Random& random, const GenerationContext& context) {
  Draft draft = any_meeting(random);
  draw_radii(random, context, draft);
  const double reach = span(draft.a.outline) + span(draft.b.outline);
  draft.gap = random.integer(-4, 4) * ulp_of(reach);
  frame(random, draft);
  draft.world.position *= 0.125;  // so that the positions' own ulps do not drown the gap
  return settle(draft);
}

std::optional<PairCase> deep(Random& random, const GenerationContext& context) {
  const Outline a = random_outline(random);
  const bool copied = random.chance(0.1);
  const double scale = random.chance(0.3) ? 1 : random.magnitude(-12, 0);
  const Outline b = copied ? a : random_outline(random);
  Draft draft = free_pair(random, a, stretched(b, scale, scale));
  if (random.chance(0.2)) draft.b.pose.rotation = {1, 0};
  draft.start = middle(a) - rotate(draft.b.pose.rotation, middle(draft.b.outline));
  const double kind = random.unit();
  if (kind < 0.6) {
    const double off = kind < 0.3 ? random.magnitude(-24, -2) : random.uniform(0, 0.3);
    draft.start += off * random_direction(random);
  }
  draw_radii(random, context, draft);
  stand(random, draft);
  return settle(maybe_swapped(random, draft));
}

std::optional<PairCase> separated(Random& random, const GenerationContext& context) {
  Draft draft = any_meeting(random);
  draw_radii(random, context, draft);
  const double gap = random.chance(0.15) ? random.uniform(0.15, 0.3) : random.magnitude(-2, 4);
  draft.gap = gap * span(draft);
  frame(random, draft);
  return settle(draft);
}

}  // namespace manifuzz::draw
