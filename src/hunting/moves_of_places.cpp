#include <algorithm>
#include <cmath>
#include <limits>

#include "generating/drafts.hpp"
#include "hunting/moves.hpp"

namespace manifuzz {
namespace {

/// A face of one shape, in the world.
struct PlacedFace {
  Vector2<double> from;
  Vector2<double> along;   ///< unit
  Vector2<double> normal;  ///< unit, outward
  double length = 0;
};

Vector2<double> placed(const Body& body, int vertex) {
  return transform<double>({body.pose.position.cast<double>(), body.pose.rotation.cast<double>()},
                           body.polygon.vertices[vertex].cast<double>());
}

PlacedFace placed_face(const Body& body, int face) {
  PlacedFace of;
  of.from = placed(body, face);
  const Vector2<double> along = placed(body, body.polygon.next(face)) - of.from;
  of.length = along.norm();
  of.along = along / of.length;
  of.normal = -counter_clockwise_quarter(of.along);
  return of;
}

PlacedFace any_face(Random& random, const Body& body) {
  return placed_face(body, random.integer(0, body.polygon.count - 1));
}

/// How far the shape lies in front of the face, its core's deepest vertex.
double in_front_of(const PlacedFace& face, const Body& body) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < body.polygon.count; ++i) {
    least = std::min(least, face.normal.dot(placed(body, i) - face.from));
  }
  return least;
}

void move_by(Body& body, const Vector2<double>& by) {
  body.pose.position = (body.pose.position.cast<double>() + by).cast<float>();
}

/// Nothing now and then, else 2^-23 to 2^-1 of a length, either way.
double small_offset(Random& random, double of) {
  if (random.chance(0.2)) return 0;
  return random.either_sign(of * power_of_two(random.integer(-23, -1)));
}

Side any_side(Random& random) {
  return random.chance(0.5) ? Side::a : Side::b;
}

/// To a multiple of 45 degrees, the other's, by a small angle, or by an ulp.
void turn(Random& random, PairCase& pair, const PairCase&) {
  const Side side = any_side(random);
  Vector2<float>& rotation = pair[side].pose.rotation;
  switch (random.integer(0, 4)) {
    case 0:
      rotation = quarter_turn(random).cast<float>();
      return;
    case 1: {
      const float half = 0.70710677F;  // of both: the float below the root of a half
      rotation.x() = random.chance(0.5) ? half : -half;
      rotation.y() = random.chance(0.5) ? half : -half;
      return;
    }
    case 2:
      rotation = pair[other(side)].pose.rotation;
      return;
    case 3: {
      const double angle = random.either_sign(power_of_two(random.integer(-24, -1)));
      rotation = rotate<double>(turn_by(angle), unit(rotation.cast<double>())).cast<float>();
      return;
    }
    default: {
      float& number = rotation[random.integer(0, 1)];
      number = stepped(number, random.chance(0.5) ? 1 : -1);
    }
  }
}

/// B turned so that its face looks at A's, but for nothing or a small angle.
void turn_to_face(Random& random, PairCase& pair, const PlacedFace& of_a, const PlacedFace& of_b) {
  const bool is_parallel = cross(of_a.along, of_b.along) == 0 && of_a.along.dot(of_b.along) < 0;
  if (is_parallel && random.chance(0.75)) return;
  // The rotation that takes B's direction to A's, turned about.
  const Vector2<double> facing = -rotate_back<double>(of_b.along, of_a.along);
  const double tilt = random.chance(0.3) ? 0 : power_of_two(random.integer(-24, -3));
  const Vector2<double> by = rotate<double>(turn_by(random.either_sign(tilt)), facing);
  pair.b.pose.rotation =
      unit(rotate<double>(by, pair.b.pose.rotation.cast<double>())).cast<float>();
}

void make_parallel(Random& random, PairCase& pair, const PairCase&) {
  if (pair.a.polygon.count < 2 || pair.b.polygon.count < 2) return;
  const PlacedFace of_a = any_face(random, pair.a);
  turn_to_face(random, pair, of_a, any_face(random, pair.b));
}

void scale_body(Body& body, double by) {
  for (int i = 0; i < body.polygon.count; ++i) body.polygon.vertices[i] *= static_cast<float>(by);
}

/// B scaled and laid with one of its faces on one of A's, anywhere along it, tilted or not, with a
/// small gap or overlap: whatever of both is longer is cut.
void lay_on(Random& random, PairCase& pair, const PairCase&) {
  if (pair.a.polygon.count < 2 || pair.b.polygon.count < 2) return;
  const int face = random.integer(0, pair.a.polygon.count - 1);
  const int edge = random.integer(0, pair.b.polygon.count - 1);
  if (random.chance(0.5)) scale_body(pair.b, random.magnitude(-4, 4));
  const PlacedFace of_a = placed_face(pair.a, face);
  turn_to_face(random, pair, of_a, placed_face(pair.b, edge));
  const PlacedFace of_b = placed_face(pair.b, edge);
  const double share = random.uniform(-0.2, 1.2);
  const double out = small_offset(random, size(pair)) + total_radius(pair);
  const Vector2<double> middle = of_b.from + of_b.length / 2 * of_b.along;
  move_by(pair.b, of_a.from + share * of_a.length * of_a.along - middle);
  move_by(pair.b, (out - in_front_of(of_a, pair.b)) * of_a.normal);
  if (random.chance(0.5)) std::swap(pair.a, pair.b);
}

/// One body along the normal of a face of the other: to contact, but for a small gap or overlap.
void bring_to_contact(Random& random, PairCase& pair, const PairCase&) {
  const Side side = any_side(random);
  if (pair[side].polygon.count < 2) return;
  const PlacedFace face = any_face(random, pair[side]);
  Body& moved = pair[other(side)];
  const double gap = small_offset(random, size(pair)) + total_radius(pair);
  move_by(moved, (gap - in_front_of(face, moved)) * face.normal);
}

/// Moves one body along a face of the other, until one of its vertices lies on a side plane of that
/// face, or a small distance from it.
void bring_to_side_plane(Random& random, PairCase& pair, const PairCase&) {
  const Side side = any_side(random);
  if (pair[side].polygon.count < 2) return;
  const PlacedFace face = any_face(random, pair[side]);
  Body& moved = pair[other(side)];
  const int vertex = random.integer(0, moved.polygon.count - 1);
  const double at = face.along.dot(placed(moved, vertex) - face.from);
  const double radius = random.chance(0.5) ? total_radius(pair) : 0;
  const double plane = random.chance(0.5) ? -radius : face.length + radius;
  move_by(moved, (plane + small_offset(random, face.length) - at) * face.along);
}

/// B round A to where the face that separates changes owner, or close.
void bring_to_a_tie(Random& random, PairCase& pair, const PairCase&) {
  if (pair.a.polygon.count < kMinVertices || pair.b.polygon.count < kMinVertices) return;
  const auto tie = find_tie(pair, random.either_sign(1));
  if (tie) put_apart(pair, place_at(faces_of(pair), *tie, small_offset(random, size(pair))));
}

/// One body into the other: their middles together, or close.
void bring_together(Random& random, PairCase& pair, const PairCase&) {
  const auto middle_of = [](const Body& body) {
    Vector2<double> sum(0, 0);
    for (int i = 0; i < body.polygon.count; ++i) sum += placed(body, i);
    return Vector2<double>(sum / body.polygon.count);
  };
  const double share = random.chance(0.5) ? 1 : random.unit();
  move_by(pair.b, share * (middle_of(pair.a) - middle_of(pair.b)));
}

/// Both away from the origin, or back to it, by the same way.
void move_both(Random& random, PairCase& pair, const PairCase&) {
  Vector2<double> by = -pair.a.pose.position.cast<double>();
  if (random.chance(0.75)) by = size(pair) * random.magnitude(-2, 24) * random_direction(random);
  move_by(pair.a, by);
  move_by(pair.b, by);
}

/// A shape's own frame to another place: nothing moves but its numbers.
void reframe_shape(Random& random, PairCase& pair, const PairCase&) {
  Body& body = pair[any_side(random)];
  const Vector2<float> by = body.polygon.vertices[random.integer(0, body.polygon.count - 1)];
  for (int i = 0; i < body.polygon.count; ++i) body.polygon.vertices[i] -= by;
  move_by(body, rotate<double>(body.pose.rotation.cast<double>(), by.cast<double>()));
}

/// One shape after the other, or the mate's after itself: turned by half a turn and scaled by a
/// power of two, so that each of its faces is exactly parallel to one of the other's.
void reflect_shape(Random& random, PairCase& pair, const PairCase& mate) {
  const Side side = any_side(random);
  const Body& model = random.chance(0.5) ? pair[other(side)] : mate[any_side(random)];
  const float by = -static_cast<float>(power_of_two(random.integer(-4, 4)));
  pair[other(side)].polygon = model.polygon;
  pair[side].polygon = model.polygon;
  scale_body(pair[side], static_cast<double>(by));
  pair[side].pose.rotation = pair[other(side)].pose.rotation;
}

void swap_bodies(Random&, PairCase& pair, const PairCase&) {
  std::swap(pair.a, pair.b);
}

void turn_both(Random&, PairCase& pair, const PairCase&) {
  turn_by_quarter(pair);
}

/// A body of the mate, or its shape alone.
void take_from_mate(Random& random, PairCase& pair, const PairCase& mate) {
  const Side side = any_side(random);
  const Body& taken = mate[any_side(random)];
  if (random.chance(0.5)) {
    pair[side] = taken;
  } else {
    pair[side].polygon = taken.polygon;
  }
}

/// The relative place of the mate's bodies.
void take_place_from_mate(Random&, PairCase& pair, const PairCase& mate) {
  pair.a.pose = mate.a.pose;
  pair.b.pose = mate.b.pose;
}

/// Whether a face of either shape has the other in front of it, radii taken off.
bool has_face_between(const PairCase& pair) {
  for (const Side side : {Side::a, Side::b}) {
    const Body& body = pair[side];
    if (body.polygon.count < 2) continue;
    for (int face = 0; face < body.polygon.count; ++face) {
      const double gap = in_front_of(placed_face(body, face), pair[other(side)]);
      if (gap > total_radius(pair)) return true;
    }
  }
  return false;
}

constexpr Move kMovesOfPlaces[] = {
    {"turn", turn},
    {"parallel", make_parallel},
    {"lay_on", lay_on},
    {"contact", bring_to_contact},
    {"side_plane", bring_to_side_plane},
    {"tie", bring_to_a_tie},
    {"together", bring_together},
    {"move_both", move_both},
    {"reframe", reframe_shape},
    {"reflect", reflect_shape},
    {"swap", swap_bodies},
    {"quarter", turn_both},
    {"body_of_mate", take_from_mate},
    {"place_of_mate", take_place_from_mate},
};

}  // namespace

std::span<const Move> moves_of_places() {
  return kMovesOfPlaces;
}

void close_gap(Random& random, PairCase& pair) {
  if (!has_face_between(pair)) return;
  const auto close = random.chance(0.5) ? bring_together : bring_to_contact;
  close(random, pair, pair);
}

}  // namespace manifuzz
