// Regimes named for the magnitudes of the numbers.

#include "generating/drafts.hpp"
#include "generating/regime_list.hpp"

namespace manifuzz::draw {

std::optional<PairCase> far_from_origin(Random& random, const GenerationContext& context) {
  Draft draft = any_meeting(random);
  aim(random, context, draft);
  frame(random, draft, 0);
  const double far = 1.19 * random.magnitude(0, 23);
  draft.world.position = far * random_direction(random);
  draft.exact_gap = far > 1000;  // where rounding the position would spoil the gap
  return settle(draft);
}

std::optional<PairCase> scaled(Random& random, const GenerationContext& context) {
  Draft draft = any_meeting(random);
  const double scale = random.magnitude(-20, 20);
  draft.a.outline = stretched(draft.a.outline, scale, scale);
  draft.b.outline = stretched(draft.b.outline, scale, scale);
  draft.start *= scale;
  aim(random, context, draft, scale);
  frame(random, draft, 0.2);
  return settle(draft);
}

std::optional<PairCase> off_unit(Random& random, const GenerationContext& context) {
  Draft draft = any_meeting(random);
  aim(random, context, draft);
  frame(random, draft, 0.2);
  for (Sketch* sketch : {&draft.a, &draft.b}) {
    const double limit = random.chance(0.5) ? kRotationTolerance : -kRotationTolerance;
    const double share = random.chance(0.3) ? 0.99 : random.unit();
    put_off_unit(*sketch, share * limit);
  }
  return settle(draft);
}

}  // namespace manifuzz::draw
