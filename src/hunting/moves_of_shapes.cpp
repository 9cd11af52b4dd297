#include <algorithm>
#include <cmath>

#include "generating/drafts.hpp"
#include "hunting/moves.hpp"

namespace manifuzz {
namespace {

using Shape = ConvexPolygon<float>;

Body& any_body(Random& random, PairCase& pair) {
  return random.chance(0.5) ? pair.a : pair.b;
}

int any_vertex(Random& random, const Shape& shape) {
  return random.integer(0, shape.count - 1);
}

Vector2<double> edge(const Shape& shape, int i) {
  return shape.vertices[shape.next(i)].cast<double>() - shape.vertices[i].cast<double>();
}

void insert_after(Shape& shape, int i, const Vector2<double>& vertex) {
  for (int k = shape.count; k > i + 1; --k) shape.vertices[k] = shape.vertices[k - 1];
  shape.vertices[i + 1] = vertex.cast<float>();
  ++shape.count;
}

/// On a face, out by 2^-20 to a half of its length.
void add_vertex(Random& random, PairCase& pair, const PairCase&) {
  Shape& shape = any_body(random, pair).polygon;
  if (shape.count == kMaxVertices || shape.count < 2) return;
  const int i = any_vertex(random, shape);
  const Vector2<double> along = edge(shape, i);
  const double share = random.uniform(0.1, 0.9);
  const double out = power_of_two(random.integer(-20, -1));
  insert_after(
      shape, i,
      shape.vertices[i].cast<double>() + share * along - out * counter_clockwise_quarter(along));
}

/// A corner cut by 2^-20 to a half of both its faces.
void cut_a_corner(Random& random, PairCase& pair, const PairCase&) {
  Shape& shape = any_body(random, pair).polygon;
  if (shape.count == kMaxVertices || shape.count < kMinVertices) return;
  const int i = any_vertex(random, shape);
  const Vector2<double> corner = shape.vertices[i].cast<double>();
  const double before = power_of_two(random.integer(-20, -2));
  const double after = random.chance(0.5) ? before : power_of_two(random.integer(-20, -2));
  const Vector2<double> second = corner + after * edge(shape, i);
  shape.vertices[i] = (corner - before * edge(shape, shape.previous(i))).cast<float>();
  insert_after(shape, i, second);
}

void remove_any_vertex(Random& random, PairCase& pair, const PairCase&) {
  Shape& shape = any_body(random, pair).polygon;
  if (shape.count <= (shape.is_round() ? 1 : kMinVertices)) return;
  const int vertex = any_vertex(random, shape);
  for (int i = vertex; i + 1 < shape.count; ++i) shape.vertices[i] = shape.vertices[i + 1];
  --shape.count;
}

/// A vertex onto the line of its neighbours, but for 2^-23 to 2^-4 of their distance.
void flatten_a_corner(Random& random, PairCase& pair, const PairCase&) {
  Shape& shape = any_body(random, pair).polygon;
  if (shape.count <= kMinVertices) return;
  const int i = any_vertex(random, shape);
  const Vector2<double> from = shape.vertices[shape.previous(i)].cast<double>();
  const Vector2<double> across = shape.vertices[shape.next(i)].cast<double>() - from;
  const Vector2<double> at = shape.vertices[i].cast<double>() - from;
  const Vector2<double> on_line = at.dot(across) / across.dot(across) * across;
  const double out = power_of_two(random.integer(-23, -4));
  shape.vertices[i] = (from + on_line - out * counter_clockwise_quarter(across)).cast<float>();
}

void scale_shape(Body& body, const Vector2<double>& by) {
  for (int i = 0; i < body.polygon.count; ++i) {
    body.polygon.vertices[i] =
        body.polygon.vertices[i].cast<double>().cwiseProduct(by).cast<float>();
  }
}

/// One shape along one axis: slivers.
void stretch(Random& random, PairCase& pair, const PairCase&) {
  const double factor = power_of_two(random.integer(-8, 8));
  scale_shape(any_body(random, pair),
              random.chance(0.5) ? Vector2<double>(factor, 1) : Vector2<double>(1, factor));
}

/// A face as long as one of the other shape, by scaling, or but for 2^-23 to 2^-4 of it.
void make_faces_alike(Random& random, PairCase& pair, const PairCase&) {
  const Side side = random.chance(0.5) ? Side::a : Side::b;
  const Shape& model = pair[other(side)].polygon;
  Body& body = pair[side];
  if (model.count < 2 || body.polygon.count < 2) return;
  const double wanted = edge(model, any_vertex(random, model)).norm();
  double factor = wanted / edge(body.polygon, any_vertex(random, body.polygon)).norm();
  if (random.chance(0.5)) factor *= 1 + power_of_two(random.integer(-23, -4));
  scale_shape(body, {factor, factor});
}

/// Everything by a power of two, or one shape alone by up to ten decades.
void scale(Random& random, PairCase& pair, const PairCase&) {
  if (random.chance(0.5)) {
    scale_lengths(pair, static_cast<float>(power_of_two(random.integer(-16, 16))));
    return;
  }
  Body& body = any_body(random, pair);
  const double factor = random.magnitude(-17, 17);
  scale_shape(body, {factor, factor});
  if (random.chance(0.5)) body.polygon.radius *= static_cast<float>(factor);
}

void change_radius(Random& random, PairCase& pair, const PairCase&) {
  const Side side = random.chance(0.5) ? Side::a : Side::b;
  float& radius = pair[side].polygon.radius;
  const float others = pair[other(side)].polygon.radius;
  switch (random.integer(0, 4)) {
    case 0:
      radius = 0;
      break;
    case 1:
      radius = others;
      break;
    case 2:
      radius = static_cast<float>(static_cast<double>(others) * random.magnitude(-14, 14));
      break;
    case 3:
      radius = static_cast<float>(size(pair) * random.magnitude(-20, 14));
      break;
    default:
      radius *= static_cast<float>(power_of_two(random.integer(-4, 4)));
  }
}

/// Corners mitred or round; or one of its faces, or one of its vertices, with a radius.
void change_kind(Random& random, PairCase& pair, const PairCase&) {
  Body& body = any_body(random, pair);
  Shape& shape = body.polygon;
  const int kind = random.integer(0, 3);
  if (kind <= 1) {
    shape.rounding = kind == 0 ? Rounding::round : Rounding::mitre;
    return;
  }
  if (!is_round(pair)) return;
  const int i = any_vertex(random, shape);
  shape.vertices = {shape.vertices[i], shape.vertices[shape.next(i)]};
  shape.count = std::min(shape.count, 4 - kind);
  if (shape.radius == 0) shape.radius = static_cast<float>(random.magnitude(-6, 1));
}

void renumber_shape(Random& random, PairCase& pair, const PairCase&) {
  Shape& shape = any_body(random, pair).polygon;
  const int times = random.integer(1, kMaxVertices - 1);
  for (int i = 0; i < times; ++i) renumber(shape);
}

constexpr Move kMovesOfShapes[] = {
    {"add_vertex", add_vertex},
    {"cut_corner", cut_a_corner},
    {"remove_vertex", remove_any_vertex},
    {"flatten", flatten_a_corner},
    {"stretch", stretch},
    {"faces_alike", make_faces_alike},
    {"scale", scale},
    {"radius", change_radius},
    {"kind", change_kind},
    {"renumber", renumber_shape},
};

}  // namespace

std::span<const Move> moves_of_shapes() {
  return kMovesOfShapes;
}

}  // namespace manifuzz
