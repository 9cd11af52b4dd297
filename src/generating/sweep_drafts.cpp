#include "generating/sweep_drafts.hpp"

#include <cmath>

namespace manifuzz {

Outline benign_outline(Random& random, int most) {
  const Outline regular =
      turned(regular_outline(random_count(random, most)), random_direction(random));
  const double scale = random.magnitude(-1, 0);
  const double flat = random.uniform(0.7, 1.4);
  return turned(stretched(regular, scale, scale * flat), random_direction(random));
}

Outline benign_partner(Random& random) {
  return face_or_corner_up(random, benign_outline(random), 0.05);
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

double gap_error(const PairCase& pair, double gap) {
  const double found = separation(faces_of(pair), apart(pair)) - total_radius(pair);
  return std::abs(found - gap) / std::abs(gap);
}

}  // namespace manifuzz
