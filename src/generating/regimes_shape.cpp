#include <algorithm>
#include <array>

#include "generating/drafts.hpp"
#include "generating/regime.hpp"

namespace manifuzz::draw {

// Regimes named for the polygons' shapes.

namespace {

/// A rotation that often is a multiple of a turn over `count`, up to half a turn: it keeps regular
/// polygons aligned, or face to face.
Vector2<double> often_aligned(Random& random, int count) {
  if (random.chance(0.4)) return random_direction(random);
  const Vector2<double> corner = regular_outline(count).vertices[random.integer(0, count - 1)];
  return random.either_sign(1) * clockwise_quarter(corner);
}

Outline random_box(Random& random) {
  const double half_width = random.magnitude(-2, 1);
  const double half_height = random.chance(0.2) ? half_width : random.magnitude(-2, 1);
  return box(half_width, half_height);
}

Outline random_sliver(Random& random) {
  const double aspect = 12 * random.magnitude(0, 13);
  return stretched(random_outline(random), 1, 1 / aspect);
}

struct GridPoint {
  int x, y;
};

int area(const GridPoint& o, const GridPoint& p, const GridPoint& q) {
  return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

/// The strictly convex hull of a few grid points (Andrew's monotone chain), at most 8 of its
/// corners.
Outline grid_hull(Random& random) {
  constexpr int most = 14;
  std::array<GridPoint, most> points;
  const int count = random.integer(3, most);
  const int half = random.integer(1, count < 6 ? 4 : 6);
  for (int i = 0; i < count; ++i) {
    const int x = random.integer(-half, half);
    const int y = random.integer(-half, half);
    points[i] = {x, y};
  }
  std::sort(points.begin(), points.begin() + count,
            [](const auto& p, const auto& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  std::array<GridPoint, 2UL * most> hull;
  int corners = 0;
  const auto extend = [&](const GridPoint& point, int keep) {
    while (corners >= keep && area(hull[corners - 2], hull[corners - 1], point) <= 0) --corners;
    hull[corners++] = point;
  };
  for (int i = 0; i < count; ++i) extend(points[i], 2);
  const int upper = corners + 1;
  for (int i = count - 2; i >= 0; --i) extend(points[i], upper);
  Outline outline;
  outline.count = std::min(corners - 1, kMaxVertices);
  for (int i = 0; i < outline.count; ++i) outline.vertices[i] = {hull[i].x, hull[i].y};
  return outline;
}

/// A rectangle with some of its corners cut off along grid lines or diagonals.
Outline grid_box(Random& random) {
  const int half_width = random.integer(1, 4);
  const int half_height = random.integer(1, 4);
  Outline outline = box(half_width, half_height);
  for (int corner = 3; corner >= 0; --corner) {
    if (random.chance(0.5)) continue;
    const double before = random.integer(1, 3);
    const double after = random.chance(0.5) ? before : random.integer(1, 3);
    const double length_before = outline.face(outline.previous(corner)).cwiseAbs().sum();
    const double length_after = outline.face(corner).cwiseAbs().sum();
    if (before >= length_before || after >= length_after) continue;
    // From the ends, not by shares, so that the corners stay integers.
    const Vector2<double> at = outline.vertices[corner];
    const Vector2<double> to_before = -outline.face(outline.previous(corner)) / length_before;
    const Vector2<double> to_after = outline.face(corner) / length_after;
    outline = with_vertex(outline, corner, at + after * to_after);
    outline.vertices[corner] = at + before * to_before;
  }
  return outline;
}

Outline random_grid_outline(Random& random) {
  return random.chance(0.6) ? grid_hull(random) : grid_box(random);
}

/// The corner farthest along `direction`.
Vector2<double> farthest(const Outline& outline, const Vector2<double>& direction) {
  Vector2<double> best = outline.vertices[0];
  for (int i = 1; i < outline.count; ++i) {
    if (direction.dot(outline.vertices[i] - best) > 0) best = outline.vertices[i];
  }
  return best;
}

/// B's place on the grid, from A's, at which one of A's faces touches B: the separation is 0,
/// exactly.
Vector2<double> grid_contact(Random& random, const Outline& a, const Outline& b) {
  const int face = random.integer(0, a.count - 1);
  const Vector2<double> outward = clockwise_quarter(a.face(face));
  const double share = 0.5 * random.integer(0, 2);
  return a.vertices[face] + share * a.face(face) - farthest(b, -outward);
}

/// A small step on the half-integer grid, often none.
Vector2<double> grid_step(Random& random) {
  if (random.chance(0.4)) return {0, 0};
  const int most = random.chance(0.7) ? 1 : 2;
  const double x = 0.5 * random.integer(-most, most);
  const double y = 0.5 * random.integer(-most, most);
  return {x, y};
}

}  // namespace

bool generic(Random& random, const GenerationContext& context, PairCase& pair) {
  Draft draft;
  draft.a.outline = random_outline(random);
  draft.b.outline = sized_outline(random);
  meet_freely(random, draft);
  draw_radii(random, context, draft);
  draft.gap = draw_gap(random, 0.07) * span(draft);
  stand(random, draft);
  return settle(draft, pair);
}

bool boxes(Random& random, const GenerationContext& context, PairCase& pair) {
  const Outline a = random_box(random);
  const Outline b = random_box(random);
  Draft draft = free_pair(random, a, b);
  draft.b.pose.rotation = often_aligned(random, 4);
  aim(random, context, draft);
  stand(random, draft);
  return settle(draft, pair);
}

bool regular(Random& random, const GenerationContext& context, PairCase& pair) {
  const int count_a = random_count(random);
  const int count_b = random.chance(0.5) ? count_a : random_count(random);
  const double scale = random.chance(0.4) ? 1 : random.magnitude(-2, 1);
  const Outline a = regular_outline(count_a);
  const Outline b = stretched(regular_outline(count_b), scale, scale);
  Draft draft = free_pair(random, a, b);
  draft.b.pose.rotation = often_aligned(random, count_a);
  if (random.chance(0.5)) draft.direction = often_aligned(random, count_a);
  aim(random, context, draft);
  stand(random, draft);
  return settle(draft, pair);
}

bool grid(Random& random, const GenerationContext& context, PairCase& pair) {
  Draft draft;
  draft.a.outline = random_grid_outline(random);
  draft.b.outline = random_grid_outline(random);
  if (draft.a.outline.count < kMinVertices || draft.b.outline.count < kMinVertices) {
    return false;
  }
  draft.b.pose.rotation = quarter_turn(random);
  const Outline b = turned(draft.b.outline, draft.b.pose.rotation);
  draft.start = grid_contact(random, draft.a.outline, b);
  draft.start += grid_step(random);
  draft.radius_a = draft.radius_b = context.radius.value_or(random.chance(0.7) ? 0.0f : 0.25f);
  draft.world.rotation = quarter_turn(random);
  const double x = 0.5 * random.integer(-20, 20);
  const double y = 0.5 * random.integer(-20, 20);
  draft.world.position = {x, y};
  return settle(maybe_swapped(random, draft), pair);
}

bool sliver(Random& random, const GenerationContext& context, PairCase& pair) {
  const Outline a = random.chance(0.5) ? random_outline(random) : random_sliver(random);
  const Outline b = random_sliver(random);
  Draft draft;
  if (random.chance(0.7)) {
    draft = any_meeting(random, a, b);
    aim(random, context, draft);
  } else {  // B's tip inside A
    draft = free_pair(random, a, b);
    const double share = random.unit();
    const Vector2<double> inside =
        middle(a) + share * (a.vertices[random.integer(0, a.count - 1)] - middle(a));
    const Vector2<double> along{random.chance(0.5) ? 1.0 : -1.0, 0};
    draft.start = inside - rotate(draft.b.pose.rotation, farthest(b, along));
    draw_radii(random, context, draft);
  }
  frame(random, draft, 0.1);
  return settle(maybe_swapped(random, draft), pair);
}

// Regimes named for the magnitudes of the numbers.

bool far_from_origin(Random& random, const GenerationContext& context, PairCase& pair) {
  Draft draft = any_meeting(random);
  aim(random, context, draft);
  frame(random, draft, 0);
  const double far = 1.19 * random.magnitude(0, 23);
  draft.world.position = far * random_direction(random);
  draft.exact_gap = far > 1000;  // where rounding the position would spoil the gap
  return settle(draft, pair);
}

bool scaled(Random& random, const GenerationContext& context, PairCase& pair) {
  Draft draft = any_meeting(random);
  const double scale = random.magnitude(-20, 20);
  draft.a.outline = stretched(draft.a.outline, scale, scale);
  draft.b.outline = stretched(draft.b.outline, scale, scale);
  draft.start *= scale;
  aim(random, context, draft, scale);
  frame(random, draft, 0.2);
  return settle(draft, pair);
}

bool off_unit(Random& random, const GenerationContext& context, PairCase& pair) {
  Draft draft = any_meeting(random);
  aim(random, context, draft);
  frame(random, draft, 0.2);
  for (Sketch* sketch : {&draft.a, &draft.b}) {
    const double limit = random.chance(0.5) ? kRotationTolerance : -kRotationTolerance;
    const double share = random.chance(0.3) ? 0.99 : random.unit();
    put_off_unit(*sketch, share * limit);
  }
  return settle(draft, pair);
}

}  // namespace manifuzz::draw
