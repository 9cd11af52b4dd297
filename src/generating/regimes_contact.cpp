#include <cmath>

#include "base/random.hpp"
#include "generating/drafts.hpp"
#include "generating/regime.hpp"
#include "geometry/convex_polygon.hpp"

namespace manifuzz::draw {

// Regimes named for how the polygons meet.

namespace {

bool met(Random& random, const GenerationContext& context, Draft draft, PairCase& pair,
         double exact = 0.5) {
  aim(random, context, draft);
  frame(random, draft, exact);
  return settle(maybe_swapped(random, draft), pair);
}

}  // namespace

bool near_parallel(Random& random, const GenerationContext& context, PairCase& pair) {
  const Outline a = sized_outline(random);
  const Outline b = sized_outline(random);
  const double tilt = random.chance(0.15) ? 0 : random.either_sign(random.magnitude(-30, -3));
  return met(random, context, face_to_face(random, a, b, tilt), pair);
}

bool corner_face(Random& random, const GenerationContext& context, PairCase& pair) {
  const Outline a = sized_outline(random);
  const Outline b = sized_outline(random);
  return met(random, context, corner_to_face(random, a, b), pair);
}

bool corner_corner(Random& random, const GenerationContext& context, PairCase& pair) {
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
  return settle(maybe_swapped(random, draft), pair);
}

bool touching(Random& random, const GenerationContext& context, PairCase& pair) {
  Draft draft = any_meeting(random);
  draw_radii(random, context, draft);
  const double reach = span(draft.a.outline) + span(draft.b.outline);
  draft.gap = random.integer(-4, 4) * ulp_of(reach);
  frame(random, draft);
  draft.world.position *= 0.125;  // so that the positions' own ulps do not drown the gap
  return settle(draft, pair);
}

bool deep(Random& random, const GenerationContext& context, PairCase& pair) {
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
  return settle(maybe_swapped(random, draft), pair);
}

bool separated(Random& random, const GenerationContext& context, PairCase& pair) {
  Draft draft = any_meeting(random);
  draw_radii(random, context, draft);
  const double gap = random.chance(0.15) ? random.uniform(0.15, 0.3) : random.magnitude(-2, 4);
  draft.gap = gap * span(draft);
  frame(random, draft);
  return settle(draft, pair);
}

// Regimes in which two features are nearly as good as each other.

namespace {

/// None, or a little to either side.
double often_none(Random& random, int low, int high) {
  return random.chance(0.4) ? 0 : random.either_sign(random.magnitude(low, high));
}

/// A shallow roof for A, its ridge at the origin; B narrow, wholly over one side of it. The roof's
/// two faces tie in float, and only one of their slabs holds B.
Draft roof(Random& random) {
  const Outline a = random_outline(random, random_count(random, kMaxVertices - 1));
  const int face = random.integer(0, a.count - 1);
  const double wide = length(a.face(face));
  const Outline flat = face_up(a, face, random.uniform(0.2, 0.8));
  const double narrow = wide * random.magnitude(-8, 0);
  const Outline b = random_outline(random);
  const int corner = random.integer(0, b.count - 1);
  const Outline tip = upside_down(corner_up(b, corner, random.uniform(0.05, 0.95)));
  Draft draft;
  draft.a.outline = with_vertex(flat, face, {0, wide * random.magnitude(-34, -8)});
  const double tall = random.chance(0.5) ? narrow : wide * random.magnitude(-2, 0);
  draft.b.outline = stretched(tip, narrow, tall);
  draft.start.x() = random.either_sign(wide * random.magnitude(-10, -1));
  return draft;
}

/// Mirror-symmetric, with a corner at the origin, or else the middle of a face, and all below it.
Outline symmetric(Random& random, bool corner) {
  const int count = random_count(random);
  const double width = random.magnitude(-3, 1);
  const double height = random.magnitude(-3, 1);
  const Outline outline = stretched(regular_outline(count), width, height);
  if (corner) return moved(outline, {0, -height});
  return face_up(outline, random.integer(0, count - 1), 0.5);
}

/// B's corner points straight into A's corner or face, or all but straight: faces or incident edges
/// on both sides of the axis tie.
Draft symmetric_meeting(Random& random) {
  Draft draft;
  draft.a.outline = symmetric(random, random.chance(0.5));
  const double tilt = often_none(random, -30, -8);
  draft.b.outline = turned(upside_down(symmetric(random, true)), unit({1, tilt}));
  draft.start.x() = often_none(random, -30, -8);
  return draft;
}

/// A strip through, or across, the middle of a polygon: the opposite long faces tie.
Draft strip(Random& random) {
  Draft draft;
  const int count = 2 * random.integer(2, 4);
  const double length = random.magnitude(0, 2);
  const double width = random.magnitude(-6, 0);
  draft.a.outline = stretched(regular_outline(count), length, width);
  draft.b.outline = symmetric(random, true);
  const double middle = random.uniform(0, 0.5) * span(draft.b.outline);
  draft.start.x() = often_none(random, -26, -3);
  draft.start.y() = middle + often_none(random, -30, -8);
  return draft;
}

/// A corner with a tiny chamfer, at the origin and up; half the time the chamfer faces up.
Outline micro_corner(Random& random) {
  const Outline outline = sized_outline(random, kMaxVertices - 1);
  const int corner = random.integer(0, outline.count - 1);
  const Outline up = corner_up(outline, corner, random.unit());
  const double length = span(up) * random.magnitude(-23, -6);
  const double before = random.uniform(0.2, 1) * length;
  const double after = random.uniform(0.2, 1) * length;
  const Outline cut = cut_corner(up, corner, before, after);
  return random.chance(0.5) ? cut : face_up(cut, corner, random.unit());
}

/// Something to meet at the origin, below it: a face, a corner, or a corner with a chamfer.
Outline partner(Random& random, bool micro) {
  if (micro) return micro_corner(random);
  return face_or_corner_up(random, sized_outline(random), 0.02);
}

/// A vertex near the origin, which lies on the face, out by the fewest steps of floats that leave
/// the corner convex. The face's ends are rounded for it.
Outline least_bulge(const Outline& outline, int face, double share) {
  Outline result = outline;
  Vector2<double>& from = result.vertices[face];
  Vector2<double>& to = result.vertices[result.next(face)];
  from = from.cast<float>().cast<double>();
  to = to.cast<float>().cast<double>();
  const Vector2<double> outward = clockwise_quarter(result.face(face));
  const int axis = std::abs(outward.x()) > std::abs(outward.y()) ? 0 : 1;
  Vector2<float> vertex = (from + share * result.face(face)).cast<float>();
  for (int i = 0; i < 8 && orientation(from, vertex.cast<double>(), to) <= 0; ++i) {
    vertex[axis] = stepped(vertex[axis], outward[axis] > 0 ? 1 : -1);
  }
  return with_vertex(result, face, vertex.cast<double>());
}

/// By how much B's face is to lead A's.
double draw_lead(Random& random) {
  constexpr double bias = 0.0005;  // Box2D's
  const double kind = random.unit();
  if (kind < 0.25) return bias * random.unit();
  const double around = kind < 0.6 ? 0 : bias;
  return around + often_none(random, -30, -10);
}

}  // namespace

bool tied_faces(Random& random, const GenerationContext& context, PairCase& pair) {
  const int kind = random.integer(0, 4);
  Draft draft = kind < 2 ? roof(random) : kind < 4 ? symmetric_meeting(random) : strip(random);
  aim(random, context, draft);
  if (kind == 4) draft.gap.reset();
  frame(random, draft);
  return settle(maybe_swapped(random, draft), pair);
}

bool micro_edge(Random& random, const GenerationContext& context, PairCase& pair) {
  Draft draft;
  draft.a.outline = micro_corner(random);
  draft.b.outline = upside_down(partner(random, random.chance(0.3)));
  if (random.chance(0.3)) draft.start.x() = span(draft) * often_none(random, -23, -6);
  return met(random, context, draft, pair, 0.7);
}

bool near_collinear(Random& random, const GenerationContext& context, PairCase& pair) {
  const Outline outline = sized_outline(random, kMaxVertices - 1);
  const int face = random.integer(0, outline.count - 1);
  const double share = random.uniform(0.05, 0.95);
  Draft draft;
  draft.a.outline = face_up(outline, face, share);
  draft.b.outline = upside_down(partner(random, false));
  if (random.chance(0.3)) draft.start.x() = span(draft) * often_none(random, -23, -3);
  const bool least = random.chance(0.5);
  if (!least) {
    const double height = span(draft) * random.magnitude(-40, -6);
    draft.a.outline = with_vertex(draft.a.outline, face, {0, height});
  }
  aim(random, context, draft);
  frame(random, draft, least ? 0.2 : 0.6);
  if (least) draft.a.outline = least_bulge(draft.a.outline, face, share);
  return settle(maybe_swapped(random, draft), pair);
}

bool tie_bias(Random& random, const GenerationContext& context, PairCase& pair) {
  Draft draft = any_meeting(random);
  draw_radii(random, context, draft);
  const double gap = random.chance(0.5) ? -random.magnitude(-20, -7) : draw_gap(random);
  draft.gap = gap * span(draft);
  frame(random, draft, 0.2);
  if (!settle(draft, pair)) return false;
  const auto tie = find_tie(pair, random.either_sign(1));
  if (!tie) return false;
  const double lead = draw_lead(random);
  const auto place = [&](const Faces& faces) { return place_at(faces, *tie, lead); };
  if (random.chance(0.7)) return place_exactly(pair, place);
  put_apart(pair, place(faces_of(pair)));
  return true;
}

}  // namespace manifuzz::draw
