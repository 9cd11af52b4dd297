#include <algorithm>

#include "generating/drafts.hpp"

namespace manifuzz {
namespace {

template <class Map>
Outline mapped(const Outline& outline, Map map) {
  Outline result;
  result.count = outline.count;
  for (int i = 0; i < outline.count; ++i) result.vertices[i] = map(outline.vertices[i]);
  return result;
}

/// The point of the unit circle that lies `turn` in [0, 4) quarters from (1, 0), or nearly.
Vector2<double> circle_point(double turn) {
  const int quadrant = static_cast<int>(turn);
  const double t = turn - quadrant;
  const double scale = 1 / (1 + t * t);
  const double x = (1 - t * t) * scale;
  const double y = 2 * t * scale;
  const Vector2<double> turned_by[] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};
  return turned_by[quadrant];
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

/// A triangle or quadrilateral with its corners cut until there are `count`: edges of all lengths.
Outline carved(Random& random, int count) {
  Outline outline = inscribed(random, std::min(count, random.integer(3, 4)));
  while (outline.count < count) {
    const int corner = random.integer(0, outline.count - 1);
    const double before = random.uniform(0.1, 0.45);
    const double after = random.uniform(0.1, 0.45);
    outline = chamfered(outline, corner, before, after);
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
  const Outline outline = random.chance(0.6) ? inscribed(random, count) : carved(random, count);
  const double flat = random.uniform(0.4, 1);
  const Vector2<double> rotation = random_direction(random);
  return mapped(outline, [&](const auto& v) {
    return rotate<double>(rotation, {v.x(), flat * v.y()});
  });
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
  Vector2<double> sum{0, 0};
  for (int i = 0; i < outline.count; ++i) sum += outline.vertices[i];
  return sum / outline.count;
}

double span(const Outline& outline) {
  Vector2<double> low = outline.vertices[0];
  Vector2<double> high = low;
  for (int i = 1; i < outline.count; ++i) {
    low = low.cwiseMin(outline.vertices[i]);
    high = high.cwiseMax(outline.vertices[i]);
  }
  return (high - low).maxCoeff();
}

Outline stretched(const Outline& outline, double x, double y) {
  return mapped(outline, [&](const auto& v) { return Vector2<double>(x * v.x(), y * v.y()); });
}

Outline turned(const Outline& outline, const Vector2<double>& rotation) {
  return mapped(outline, [&](const auto& v) { return rotate(rotation, v); });
}

Outline moved(const Outline& outline, const Vector2<double>& by) {
  return mapped(outline, [&](const auto& v) { return Vector2<double>(v + by); });
}

Outline face_up(const Outline& outline, int face, double share) {
  const Vector2<double> along = unit(outline.face(face));
  const Vector2<double> origin = outline.vertices[face] + share * outline.face(face);
  Outline result =
      mapped(outline, [&](const auto& v) { return rotate_back<double>(-along, v - origin); });
  result.vertices[face].y() = 0;
  result.vertices[result.next(face)].y() = 0;
  return result;
}

Outline corner_up(const Outline& outline, int corner, double lean) {
  const Vector2<double> before = face_normal(outline, outline.previous(corner));
  const Vector2<double> after = face_normal(outline, corner);
  const Vector2<double> out = unit(before * (1 - lean) + after * lean);
  const Vector2<double> rotation = clockwise_quarter(out);
  const Vector2<double> origin = outline.vertices[corner];
  return mapped(outline, [&](const auto& v) { return rotate_back<double>(rotation, v - origin); });
}

Outline upside_down(const Outline& outline) {
  return stretched(outline, -1, -1);
}

Outline chamfered(const Outline& outline, int corner, double before, double after) {
  const Vector2<double> to_before = -outline.face(outline.previous(corner));
  Outline result =
      with_vertex(outline, corner, outline.vertices[corner] + after * outline.face(corner));
  result.vertices[corner] += before * to_before;
  return result;
}

Outline cut_corner(const Outline& outline, int corner, double before, double after) {
  const auto share = [](double cut, const Vector2<double>& face) {
    return std::min(0.45, cut / length(face));
  };
  return chamfered(outline, corner, share(before, outline.face(outline.previous(corner))),
                   share(after, outline.face(corner)));
}

Outline with_vertex(const Outline& outline, int face, const Vector2<double>& vertex) {
  Outline result = outline;
  for (int i = result.count; i > face + 1; --i) result.vertices[i] = result.vertices[i - 1];
  result.vertices[face + 1] = vertex;
  ++result.count;
  return result;
}

}  // namespace manifuzz
