#include <algorithm>

#include "generating/drafts.hpp"
#include "geometry/both.hpp"

namespace manifuzz {
namespace {

template <class Map>
void change(Outline& outline, const Map& map) {
  for (int i = 0; i < outline.count; ++i)
    store(map(both(outline.vertices[i])), outline.vertices[i]);
}

template <class Map>
Outline mapped(const Outline& outline, const Map& map) {
  Outline result;
  result.count = outline.count;
  for (int i = 0; i < outline.count; ++i) store(map(both(outline.vertices[i])), result.vertices[i]);
  return result;
}

/// The point of the unit circle that lies `turn` in [0, 4) quarters from (1, 0), or nearly.
Vector2<double> circle_point(double turn) {
  const int quadrant = static_cast<int>(turn);
  const double t = turn - quadrant;
  const double scale = 1 / (1 + t * t);
  const double x = (1 - t * t) * scale;
  const double y = 2 * t * scale;
  static constexpr Both signs[] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  return vector((quadrant % 2 == 0 ? Both{x, y} : Both{y, x}) * signs[quadrant]);
}

Vector2<double> face_normal(const Outline& outline, int face) {
  return clockwise_quarter(unit(outline.face(face)));
}

/// Corners on a circle of radius 1, at random angles.
Outline inscribed(Random& random, int count) {
  std::array<double, kMaxVertices> gaps{};
  double total = 0;
  for (int i = 0; i < count; ++i) total += gaps[i] = 0.15 + random.unit();
  Outline outline;
  outline.count = count;
  double turn = 4 * random.unit();
  for (int i = 0; i < count; ++i) {
    outline.vertices[i] = circle_point(turn);
    turn += gaps[i] * (4 / total);
    if (turn >= 4) turn -= 4;
  }
  return outline;
}

void insert(Outline& outline, int face, const Vector2<double>& vertex) {
  for (int i = outline.count; i > face + 1; --i) outline.vertices[i] = outline.vertices[i - 1];
  outline.vertices[face + 1] = vertex;
  ++outline.count;
}

void chamfer(Outline& outline, int corner, double before, double after) {
  const Vector2<double> to_before = -outline.face(outline.previous(corner));
  insert(outline, corner, outline.vertices[corner] + after * outline.face(corner));
  outline.vertices[corner] += before * to_before;
}

/// A triangle or quadrilateral with its corners cut until there are `count`: edges of all lengths.
Outline carved(Random& random, int count) {
  Outline outline = inscribed(random, std::min(count, random.integer(3, 4)));
  while (outline.count < count) {
    const int corner = random.integer(0, outline.count - 1);
    const double before = random.uniform(0.1, 0.45);
    const double after = random.uniform(0.1, 0.45);
    chamfer(outline, corner, before, after);
  }
  return outline;
}

}  // namespace

Vector2<double> random_direction(Random& random) {
  return circle_point(4 * random.unit());
}

int random_count(Random& random, int most) {
  return random.integer(kMinVertices, most);
}

Outline random_outline(Random& random, int count) {
  Outline outline = random.chance(0.6) ? inscribed(random, count) : carved(random, count);
  const Both flattened{1, random.uniform(0.4, 1)};
  const Turn turn(random_direction(random));
  change(outline, [&](const Both& v) { return turn(flattened * v); });
  return outline;
}

Outline random_outline(Random& random) {
  return random_outline(random, random_count(random));
}

Outline box(double half_width, double half_height) {
  return {.vertices = {{{-half_width, -half_height},
                        {half_width, -half_height},
                        {half_width, half_height},
                        {-half_width, half_height}}},
          .count = 4};
}

Outline regular_outline(int count) {
  // cos and sin of i / count of a turn, for the first half of the corners.
  struct Corner {
    double c, s;
  };
  constexpr double r2 = 0.70710678118654752440;
  constexpr double r3 = 0.86602540378443864676;
  constexpr Corner corners[][5] = {
      {{1, 0}, {-0.5, r3}},
      {{1, 0}, {0, 1}, {-1, 0}},
      {{1, 0},
       {0.30901699437494742410, 0.95105651629515357212},
       {-0.80901699437494742410, 0.58778525229247312917}},
      {{1, 0}, {0.5, r3}, {-0.5, r3}, {-1, 0}},
      {{1, 0},
       {0.62348980185873353053, 0.78183148246802980871},
       {-0.22252093395631440429, 0.97492791218182360702},
       {-0.90096886790241912624, 0.43388373911755812048}},
      {{1, 0}, {r2, r2}, {0, 1}, {-r2, r2}, {-1, 0}},
  };
  const auto& half = corners[count - kMinVertices];
  Outline outline;
  outline.count = count;
  for (int i = 0; i < count; ++i) {
    const bool left = 2 * i <= count;
    const Corner& corner = half[left ? i : count - i];
    outline.vertices[i] = {left ? -corner.s : corner.s, corner.c};
  }
  return outline;
}

Vector2<double> middle(const Outline& outline) {
  Both sum = both(0);
  for (int i = 0; i < outline.count; ++i) sum += both(outline.vertices[i]);
  return vector(sum / both(outline.count));
}

double span(const Outline& outline) {
  Both low = both(outline.vertices[0]);
  Both high = low;
  for (int i = 1; i < outline.count; ++i) {
    const Both vertex = both(outline.vertices[i]);
    low = low < vertex ? low : vertex;
    high = high > vertex ? high : vertex;
  }
  const Both sides = high - low;
  return std::max(sides[0], sides[1]);
}

Outline stretched(const Outline& outline, double x, double y) {
  return mapped(outline, [&](const Both& v) { return Both{x, y} * v; });
}

void scale(Outline& outline, double by) {
  change(outline, [&](const Both& v) { return both(by) * v; });
}

Outline turned(const Outline& outline, const Vector2<double>& rotation) {
  return mapped(outline, Turn(rotation));
}

Outline moved(const Outline& outline, const Vector2<double>& by) {
  return mapped(outline, [&](const Both& v) { return v + both(by); });
}

void reframe(Outline& outline, const Pose<double>& inner) {
  const Turn turn(inner.rotation);
  change(outline, [&](const Both& v) { return turn.back(v - both(inner.position)); });
}

Outline face_up(const Outline& outline, int face, double share) {
  Outline result = outline;
  const Vector2<double> along = unit(outline.face(face));
  reframe(result, {outline.vertices[face] + share * outline.face(face), -along});
  result.vertices[face].y() = 0;
  result.vertices[result.next(face)].y() = 0;
  return result;
}

Outline corner_up(const Outline& outline, int corner, double lean) {
  const Vector2<double> before = face_normal(outline, outline.previous(corner));
  const Vector2<double> after = face_normal(outline, corner);
  const Vector2<double> out = unit(before * (1 - lean) + after * lean);
  Outline result = outline;
  reframe(result, {outline.vertices[corner], clockwise_quarter(out)});
  return result;
}

Outline upside_down(const Outline& outline) {
  return stretched(outline, -1, -1);
}

Outline chamfered(Outline outline, int corner, double before, double after) {
  chamfer(outline, corner, before, after);
  return outline;
}

Outline cut_corner(const Outline& outline, int corner, double before, double after) {
  const auto share = [](double cut, const Vector2<double>& face) {
    return std::min(0.45, cut / length(face));
  };
  return chamfered(outline, corner, share(before, outline.face(outline.previous(corner))),
                   share(after, outline.face(corner)));
}

Outline with_vertex(Outline outline, int face, const Vector2<double>& vertex) {
  insert(outline, face, vertex);
  return outline;
}

}  // namespace manifuzz
