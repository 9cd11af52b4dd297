#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/random.hpp"
#include "generating/drafts.hpp"
#include "generating/sweep.hpp"

namespace manifuzz::turn {

// Sweeps named for where the polygons are and how large.

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

/// Touching or nearly so, anywhere near the origin, A and B exchanged half the time.
bool settled(Random& random, Draft draft, double unit, PairCase& pair) {
  meet(random, draft, unit);
  stand_near(random, draft);
  return settle(maybe_swapped(random, draft), pair);
}

bool sized(Random& random, double scale, PairCase& pair) {
  Draft draft = benign_pair(random, scale, scale);
  meet(random, draft, span(draft));
  stand_near(random, draft);
  return settle(draft, pair);
}

}  // namespace

bool distance(Random& random, double value, PairCase& pair) {
  Draft draft = benign_pair(random, 1, 1);
  meet(random, draft, span(draft));
  stand_near(random, draft);
  draft.world.position = value * random_direction(random);
  return settle(draft, pair);
}

bool small(Random& random, double value, PairCase& pair) {
  return sized(random, value, pair);
}

bool large(Random& random, double value, PairCase& pair) {
  return sized(random, value, pair);
}

bool ratio(Random& random, double value, PairCase& pair) {
  const Outline large = benign_outline(random);
  const Outline regular = benign_outline(random);
  const double scale = diameter(large) / (value * diameter(regular));
  const Draft draft = met(random, large, stretched(regular, scale, scale));
  return settled(random, draft, span(draft), pair);
}

bool depth(Random& random, double value, PairCase& pair) {
  constexpr double roomy = 10;  // deep enough for all of B
  Draft draft = benign_pair(random, roomy, 1);
  draft.gap = -value * std::min(diameter(draft.a.outline), diameter(draft.b.outline));
  stand_near(random, draft);
  draft = maybe_swapped(random, draft);
  if (!settle(draft, pair)) return false;
  const double off = separation(faces_of(pair), apart(pair)) - total_radius(pair) - *draft.gap;
  return std::abs(off) / std::abs(*draft.gap) <= 0.01;
}

bool off_unit(Random& random, double value, PairCase& pair) {
  Draft draft = benign_pair(random, 1, 1);
  meet(random, draft, span(draft));
  stand_near(random, draft);
  for (Sketch* sketch : {&draft.a, &draft.b}) put_off_unit(*sketch, random.either_sign(value));
  return settle(draft, pair);
}

// Sweeps named for the polygons' shapes. What is delicate keeps the drawing's axes and lies at its
// origin, where floats are dense.

namespace {

/// A delicate outline below, a benign partner above.
bool met_from_above(Random& random, const Outline& delicate, PairCase& pair) {
  Draft draft;
  draft.a.outline = delicate;
  draft.b.outline = upside_down(face_or_corner_up(random, benign_outline(random), 0.05));
  give_own_axes(random, draft.b);
  return settled(random, draft, span(draft), pair);
}

}  // namespace

bool angle(Random& random, double value, PairCase& pair) {
  const Outline a = benign_outline(random);
  const Outline b = benign_outline(random);
  const Draft draft = face_to_face(random, a, b, random.either_sign(value));
  return settled(random, draft, span(draft), pair);
}

bool aspect(Random& random, double value, PairCase& pair) {
  const auto sliver = [&] {
    const Outline regular = regular_outline(random_count(random));
    return stretched(turned(regular, random_direction(random)), 1, 1 / value);
  };
  const Outline a = random.chance(0.5) ? benign_outline(random) : sliver();
  const Outline b = sliver();
  Draft draft = free_pair(random, a, b);
  if (random.chance(0.3)) draft.direction = draft.b.pose.rotation;
  return settled(random, draft, random.chance(0.5) ? 1 : 1 / value, pair);
}

bool collinear(Random& random, double value, PairCase& pair) {
  const Outline outline = benign_outline(random, kMaxVertices - 1);
  const int face = random.integer(0, outline.count - 1);
  const double share = random.uniform(0.2, 0.8);
  const Outline up = face_up(outline, face, share);
  const double before = share * length(up.face(face));
  const double after = (1 - share) * length(up.face(face));
  const double height = value / (1 / before + 1 / after);
  return met_from_above(random, with_vertex(up, face, {0, height}), pair);
}

bool chamfer(Random& random, double value, PairCase& pair) {
  const Outline outline = benign_outline(random, kMaxVertices - 1);
  const int corner = random.integer(0, outline.count - 1);
  const Outline up = corner_up(outline, corner, random.unit());
  const double length = value * span(up);
  const Outline cut = cut_corner(up, corner, length, length);
  const bool chamfer_faces_up = random.chance(0.5);
  return met_from_above(random, chamfer_faces_up ? face_up(cut, corner, random.unit()) : cut, pair);
}

// Sweeps that come near to where a decision turns, in steps of an ulp at 1.

namespace {

constexpr double kUlp = 0x1p-23;
constexpr double kAccuracy = 0.05 * kUlp;

/// The greatest separation of one side's faces, with B at p from A.
double greatest(const Faces& faces, Side side, const Vector2<double>& p) {
  double separation = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < faces.count(); ++k) {
    if (faces.side(k) == side) separation = std::max(separation, faces.separation(k, p));
  }
  return separation;
}

/// A's face and B's that separate alike, but for B's lead.
bool tied_sides(Random& random, double lead, PairCase& pair) {
  const Outline a = benign_outline(random);
  const Outline b = benign_outline(random);
  Draft draft = any_meeting(random, a, b);
  draft.gap = -random.uniform(0.001, 0.1) * span(draft);
  draft.world.rotation = random_direction(random);
  if (!settle(draft, pair)) return false;
  const auto tie = find_tie(pair, random.either_sign(1));
  if (!tie) return false;
  const auto place = [&](const Faces& faces) { return place_at(faces, *tie, lead); };
  if (!place_exactly(pair, place)) return false;
  const Faces placed = faces_of(pair);
  const Vector2<double> at = apart(pair);
  const double off = greatest(placed, Side::b, at) - greatest(placed, Side::a, at) - lead;
  return std::abs(off) < kAccuracy;
}

/// B's corner points straight at A's face, but for `tilt`: the edges on both sides of it tie. B is
/// mirror-symmetric to the last bit, and nothing may move its vertices.
bool tied_edges(Random& random, double tilt, PairCase& pair) {
  const Outline a = benign_outline(random);
  Draft draft;
  const Outline up = face_up(a, random.integer(0, a.count - 1), random.uniform(0.2, 0.8));
  draft.a.outline = turned(up, unit({1, tilt}));
  const double scale = random.magnitude(-1, 0);
  const Outline b = moved(regular_outline(random_count(random)), {0, -1});
  draft.b.outline = upside_down(stretched(b, scale, scale));
  draft.gap = -random.uniform(0.001, 0.1) * span(draft);
  stand_near(random, draft);
  draft.exact_gap = false;
  return settle(maybe_swapped(random, draft), pair);
}

}  // namespace

bool tie(Random& random, double value, PairCase& pair) {
  constexpr double box2d_bias = 0.0005;
  const double off = random.either_sign(value * kUlp);
  switch (random.integer(0, 2)) {
    case 0:
      return tied_sides(random, off, pair);
    case 1:
      return tied_sides(random, box2d_bias + off, pair);
    default:
      return tied_edges(random, off, pair);
  }
}

bool touch(Random& random, double value, PairCase& pair) {
  Draft draft = benign_pair(random, 1, 1);
  if (random.chance(0.25)) draft.radius_a = draft.radius_b = 0.01F;
  draft.gap = random.either_sign(value * kUlp);
  stand_near(random, draft);
  if (!settle(draft, pair)) return false;
  const double target = total_radius(pair) + *draft.gap;
  Vector2<double> start = apart(pair);
  const auto place = [&](const Faces& faces) {
    const Vector2<double> from = std::exchange(start, {0, 0});
    return slide(faces, from, rotate(draft.world.rotation, draft.direction), target);
  };
  if (!place_exactly(pair, place)) return false;
  const double off = separation(faces_of(pair), apart(pair)) - target;
  return std::abs(off) < kAccuracy;
}

bool corner(Random& random, double value, PairCase& pair) {
  const auto face_from_origin = [&] {
    const Outline outline = benign_outline(random);
    const int face = random.integer(0, outline.count - 1);
    return face_up(outline, face, random.chance(0.5) ? 0 : 1);
  };
  Draft draft;
  draft.a.outline = face_from_origin();
  const double tilt = random.uniform(-0.1, 0.1);
  draft.b.outline = turned(upside_down(face_from_origin()), unit({1, tilt}));
  draft.start.x() = random.either_sign(value * kUlp);
  draft.gap = -random.uniform(0, 0.05) * span(draft);
  stand_near(random, draft);
  return settle(maybe_swapped(random, draft), pair);
}

}  // namespace manifuzz::turn
