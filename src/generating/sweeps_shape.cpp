// Sweeps named for the polygons' shapes. What is delicate keeps the drawing's axes and lies at its
// origin, where floats are dense.

#include "generating/sweep_drafts.hpp"
#include "generating/sweep_list.hpp"

namespace manifuzz::turn {
namespace {

/// A delicate outline below, a benign partner above.
std::optional<PairCase> met_from_above(Random& random, const Outline& delicate) {
  Draft draft;
  draft.a.outline = delicate;
  draft.b.outline = upside_down(benign_partner(random));
  give_own_axes(random, draft.b);
  meet(random, draft);
  stand_near(random, draft);
  return settle(maybe_swapped(random, draft));
}

}  // namespace

std::optional<PairCase> angle(Random& random, double value) {
  const Outline a = benign_outline(random);
  const Outline b = benign_outline(random);
  Draft draft = face_to_face(random, a, b, random.either_sign(value));
  meet(random, draft);
  stand_near(random, draft);
  return settle(maybe_swapped(random, draft));
}

std::optional<PairCase> aspect(Random& random, double value) {
  const auto sliver = [&] {
    const Outline regular = regular_outline(random_count(random));
    return stretched(turned(regular, random_direction(random)), 1, 1 / value);
  };
  const Outline a = random.chance(0.5) ? benign_outline(random) : sliver();
  const Outline b = sliver();
  Draft draft = free_pair(random, a, b);
  if (random.chance(0.3)) draft.direction = draft.b.pose.rotation;
  meet(random, draft, random.chance(0.5) ? 1 : 1 / value);
  stand_near(random, draft);
  return settle(maybe_swapped(random, draft));
}

std::optional<PairCase> collinear(Random& random, double value) {
  const Outline outline = benign_outline(random, kMaxVertices - 1);
  const int face = random.integer(0, outline.count - 1);
  const double share = random.uniform(0.2, 0.8);
  const Outline up = face_up(outline, face, share);
  const double before = share * length(up.face(face));
  const double after = (1 - share) * length(up.face(face));
  const double height = value / (1 / before + 1 / after);
  return met_from_above(random, with_vertex(up, face, {0, height}));
}

std::optional<PairCase> chamfer(Random& random, double value) {
  const Outline outline = benign_outline(random, kMaxVertices - 1);
  const int corner = random.integer(0, outline.count - 1);
  const Outline up = corner_up(outline, corner, random.unit());
  const double length = value * span(up);
  const Outline cut = cut_corner(up, corner, length, length);
  const bool chamfer_faces_up = random.chance(0.5);
  return met_from_above(random, chamfer_faces_up ? face_up(cut, corner, random.unit()) : cut);
}

}  // namespace manifuzz::turn
