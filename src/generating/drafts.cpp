#include "generating/drafts.hpp"

#include <algorithm>

namespace manifuzz {
namespace {

/// Gives the sketch's outline another frame, which stands in the old one as `inner`; nothing moves.
void reframe(Sketch& sketch, const Pose<double>& inner) {
  reframe(sketch.outline, inner);
  sketch.pose = {transform(sketch.pose, inner.position),
                 rotate(sketch.pose.rotation, inner.rotation)};
}

/// A point around the middle, up to a few spans away.
Vector2<double> random_origin(Random& random, const Outline& outline) {
  if (random.chance(0.5)) return middle(outline);
  const double far = random.uniform(0, random.chance(0.8) ? 0.6 : 3) * span(outline);
  return middle(outline) + far * random_direction(random);
}

int random_place(Random& random, const Outline& outline) {
  return random.integer(0, outline.count - 1);
}

Outline random_face_up(Random& random, const Outline& outline) {
  const int face = random_place(random, outline);
  return face_up(outline, face, random.uniform(0.05, 0.95));
}

Outline random_corner_up(Random& random, const Outline& outline) {
  const int corner = random_place(random, outline);
  return corner_up(outline, corner, random.uniform(0.05, 0.95));
}

float draw_radius(Random& random, double size) {
  return static_cast<float>(size * random.magnitude(-12, -3));
}

}  // namespace

void meet_freely(Random& random, Draft& draft) {
  draft.b.pose.rotation = random_direction(random);
  draft.start = middle(draft.a.outline) - rotate(draft.b.pose.rotation, middle(draft.b.outline));
  draft.direction = random_direction(random);
}

Draft free_pair(Random& random, const Outline& a, const Outline& b) {
  Draft draft{.a = {.outline = a}, .b = {.outline = b}};
  meet_freely(random, draft);
  return draft;
}

Draft face_to_face(Random& random, const Outline& a, const Outline& b, double tilt) {
  Draft draft;
  draft.a.outline = random_face_up(random, a);
  const Outline facing = upside_down(random_face_up(random, b));
  draft.b.outline = turned(facing, unit({1, tilt}));
  return draft;
}

Draft corner_to_face(Random& random, const Outline& a, const Outline& b) {
  Draft draft;
  draft.a.outline = random_face_up(random, a);
  draft.b.outline = upside_down(random_corner_up(random, b));
  return draft;
}

Draft corner_to_corner(Random& random, const Outline& a, const Outline& b) {
  Draft draft;
  draft.a.outline = random_corner_up(random, a);
  draft.b.outline = upside_down(random_corner_up(random, b));
  return draft;
}

Draft any_meeting(Random& random, const Outline& a, const Outline& b) {
  const int kind = random.integer(0, 3);
  if (kind == 0) return free_pair(random, a, b);
  if (kind == 1)
    return maybe_swapped(random, face_to_face(random, a, b, random.uniform(-0.1, 0.1)));
  if (kind == 2) return maybe_swapped(random, corner_to_face(random, a, b));
  return maybe_swapped(random, corner_to_corner(random, a, b));
}

Draft any_meeting(Random& random) {
  const Outline a = sized_outline(random);
  const Outline b = sized_outline(random);
  return any_meeting(random, a, b);
}

Outline sized_outline(Random& random, int most) {
  Outline outline = random_outline(random, random_count(random, most));
  scale(outline, random.magnitude(-2, 1));
  return outline;
}

Outline face_or_corner_up(Random& random, const Outline& outline, double margin) {
  const int place = random_place(random, outline);
  if (random.chance(0.5)) return face_up(outline, place, random.uniform(margin, 1 - margin));
  return corner_up(outline, place, random.uniform(margin, 1 - margin));
}

Draft maybe_swapped(Random& random, const Draft& draft) {
  return random.chance(0.5) ? swapped(draft) : draft;
}

double span(const Draft& draft) {
  return std::min(span(draft.a.outline), span(draft.b.outline));
}

void draw_radii(Random& random, const GenerationContext& context, Draft& draft, double unit) {
  const double kind = random.unit();
  if (const auto given = context.radius ? context.radius : context.mitred_radius) {
    draft.radius_a = draft.radius_b = *given;
  } else if (kind < 0.5) {
    draft.radius_a = draft.radius_b = 0;
  } else if (kind < 0.75) {
    draft.radius_a = draft.radius_b = static_cast<float>(0.01 * unit);
  } else {
    draft.radius_a = draw_radius(random, span(draft));
    draft.radius_b = kind < 0.85 ? draft.radius_a : draw_radius(random, span(draft));
    if (kind > 0.95) draft.radius_a = 0;
  }
}

double draw_gap(Random& random, double beyond) {
  const double kind = random.unit();
  if (kind < beyond) return random.uniform(0.1, 0.3);
  if (kind < 0.33) return -0.25 * random.unit();
  if (kind < 0.6) return -random.magnitude(-24, -3);
  if (kind < 0.63) return 0;
  if (kind < 0.82) return 0.098 * random.unit();
  return random.magnitude(-24, -4);
}

void aim(Random& random, const GenerationContext& context, Draft& draft, double unit) {
  draw_radii(random, context, draft, unit);
  draft.gap = draw_gap(random) * span(draft);
}

Vector2<double> quarter_turn(Random& random) {
  const Vector2<double> turns[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  return turns[random.integer(0, 3)];
}

namespace {

/// `size` is a function: three in four need it, and it is dear.
template <class Size>
Pose<double> draw_world(Random& random, const Size& size) {
  Pose<double> world;
  const double kind = random.unit();
  if (kind < 0.1) {
    world.rotation = quarter_turn(random);
  } else if (kind < 0.9) {
    world.rotation = random_direction(random);
  }
  if (random.chance(0.25)) return world;
  const double far = size() * (random.chance(0.5) ? 2 : 10);
  const double x = random.uniform(-far, far);
  const double y = random.uniform(-far, far);
  world.position = {x, y};
  return world;
}

}  // namespace

Pose<double> random_world(Random& random, double size) {
  return draw_world(random, [&] { return size; });
}

void stand(Random& random, Draft& draft) {
  for (Sketch* sketch : {&draft.a, &draft.b}) {
    if (random.chance(0.3)) {
      reframe(*sketch, {random_origin(random, sketch->outline), Vector2<double>(1, 0)});
    }
  }
  draft.world = draw_world(random, [&] { return span(draft); });
}

void frame(Random& random, Draft& draft, double exact) {
  if (random.chance(exact)) {
    if (random.chance(0.5)) draft.world.rotation = quarter_turn(random);
    return;
  }
  for (Sketch* sketch : {&draft.a, &draft.b}) {
    const Vector2<double> origin = random_origin(random, sketch->outline);
    reframe(*sketch, {origin, random_direction(random)});
  }
  draft.world = draw_world(random, [&] { return span(draft); });
}

namespace {

bool is_valid(const Pose<float>& pose) {
  return pose.position.allFinite() && pose.rotation.allFinite() && is_unit_rotation(pose.rotation);
}

bool is_valid(const ConvexPolygon<float>& shape) {
  return std::isfinite(shape.radius) && shape.radius >= 0 &&
         !find_shape_defect(shape.corners(), shape.radius);
}

}  // namespace

std::vector<float*> free_numbers(PairCase& pair) {
  std::vector<float*> numbers;
  numbers.reserve(2 * (2 * kMaxVertices + 3));
  for (const Side side : {Side::a, Side::b}) {
    Body& body = pair[side];
    for (int i = 0; i < body.polygon.count; ++i) {
      numbers.push_back(&body.polygon.vertices[i].x());
      numbers.push_back(&body.polygon.vertices[i].y());
    }
    numbers.push_back(&body.pose.position.x());
    numbers.push_back(&body.pose.position.y());
    numbers.push_back(&body.polygon.radius);
  }
  return numbers;
}

std::optional<PairCase> revalidated(PairCase pair, KnownShapes is_known) {
  for (const Side side : {Side::a, Side::b}) {
    Body& body = pair[side];
    if (!is_valid(body.pose)) return std::nullopt;
    if (side == Side::a ? is_known.a : is_known.b) continue;
    if (!is_valid(body.polygon)) return std::nullopt;
    body.polygon = make_polygon(body.polygon.corners(), body.polygon.radius, body.polygon.rounding);
  }
  return pair;
}

void turn_by_quarter(PairCase& pair) {
  for (Body* body : {&pair.a, &pair.b}) {
    body->pose.position = counter_clockwise_quarter(body->pose.position);
    body->pose.rotation = counter_clockwise_quarter(body->pose.rotation);
  }
}

void scale_lengths(PairCase& pair, float factor) {
  for (Body* body : {&pair.a, &pair.b}) {
    for (int i = 0; i < body->polygon.count; ++i) body->polygon.vertices[i] *= factor;
    body->polygon.radius *= factor;
    body->pose.position *= factor;
  }
}

void renumber(ConvexPolygon<float>& polygon) {
  for (auto* values : {&polygon.vertices, &polygon.normals}) {
    std::rotate(values->begin(), values->begin() + 1, values->begin() + polygon.count);
  }
}

std::optional<Tie> find_tie(const PairCase& pair, double sense) {
  const Faces faces = faces_of(pair);
  Vector2<double> place = apart(pair);
  const double level = separation(faces, place);
  int face = 0;
  while (faces.separation(face, place) < level) ++face;
  for (int step = 0; step < faces.count(); ++step) {
    const Vector2<double> along = sense * clockwise_quarter(faces.normal(face));
    int next = face;
    double shortest = 1e9;
    for (int k = 0; k < faces.count(); ++k) {
      const double speed = faces.normal(k).dot(along);
      if (k == face || speed < 1e-6) continue;
      const double length = (level - faces.separation(k, place)) / speed;
      if (length < shortest) {
        shortest = length;
        next = k;
      }
    }
    if (next == face) return std::nullopt;
    place += shortest * along;
    if (faces.side(next) != faces.side(face)) {
      return Tie{std::min(face, next), std::max(face, next), level};
    }
    face = next;
  }
  return std::nullopt;
}

Vector2<double> place_at(const Faces& faces, const Tie& tie, double lead) {
  const Vector2<double> m = faces.normal(tie.face_a);
  const Vector2<double> n = faces.normal(tie.face_b);
  const double x = faces.offset(tie.face_a) + (tie.separation - lead);
  const double y = faces.offset(tie.face_b) + tie.separation;
  return Vector2<double>(x * n.y() - y * m.y(), y * m.x() - x * n.x()) / cross(m, n);
}

}  // namespace manifuzz
