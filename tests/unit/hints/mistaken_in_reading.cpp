#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "clipping/collide.hpp"
#include "own_colliders/own_colliders.hpp"
#include "unit/hints/mistaken_adapters.hpp"

namespace manifuzz::test {
namespace {

using Vector = Vector2<double>;
using Placed = clipping::PlacedPair<double>;

Manifold<double> clipped(const Placed& placed) {
  return clipping::collide(placed.a, placed.b, relative_pose(placed.pose_a, placed.pose_b), 0.0);
}

Declaration in_double(Declaration declaration = make_clip64().declaration) {
  declaration.name = "mistaken";
  return declaration;
}

Collider asking(const Declaration& declaration, std::function<Answer(const PairCase&)> collide) {
  Collider collider;
  collider.declaration = declaration;
  collider.collide = std::move(collide);
  return collider;
}

/// What a right collider says of another pair than it was asked about, by its figures in the
/// world, or in A's frame.
Collider asked_about(const Collider& right, PairCase (*other)(const PairCase&), bool in_world) {
  Collider mistaken = right;
  mistaken.declaration.name = "mistaken";
  mistaken.collide = [=](const PairCase& pair) {
    const PairCase seen = other(pair);
    auto manifold = std::get<Manifold<double>>(right.collide(seen));
    for (int i = 0; in_world && i < manifold.count; ++i) {
      Vector& position = manifold.points[i].position;
      position = to_local(pair.a.pose, to_world(seen, position));
    }
    if (in_world) manifold.normal = local_normal(pair, world_normal(seen, manifold.normal));
    return Answer(manifold);
  };
  return mistaken;
}

template <int numerator, int denominator>
PairCase turned(const PairCase& pair) {
  PairCase seen = pair;
  for (Body* const body : {&seen.a, &seen.b}) {
    const Vector rotation = body->pose.rotation.cast<double>();
    const double angle = std::atan2(rotation.y(), rotation.x()) *
                         std::pow(180 / std::numbers::pi, numerator - denominator);
    body->pose.rotation = Vector(std::cos(angle), std::sin(angle)).cast<float>();
  }
  return seen;
}

PairCase turned_backwards(const PairCase& pair) {
  PairCase seen = pair;
  for (Body* const body : {&seen.a, &seen.b}) body->pose.rotation.y() *= -1;
  return seen;
}

PairCase flipped(const PairCase& pair) {
  PairCase seen = pair;
  for (Body* const body : {&seen.a, &seen.b}) {
    std::vector<Vector2<float>> vertices;
    for (const auto& v : body->polygon.corners()) {
      vertices.insert(vertices.begin(), {v.x(), -v.y()});
    }
    body->polygon = make_polygon<float>(vertices, body->polygon.radius, body->polygon.rounding);
  }
  return seen;
}

template <int times>
PairCase with_radii_times(const PairCase& pair) {
  PairCase seen = pair;
  for (Body* const body : {&seen.a, &seen.b}) body->polygon.radius *= times;
  return seen;
}

Answer by_float_normals(const PairCase& pair) {
  Placed placed = clipping::placed_pair<double>(pair);
  for (int i = 0; i < kMaxVertices; ++i) {
    placed.a.normals[i] = pair.a.polygon.normals[i].cast<double>();
    placed.b.normals[i] = pair.b.polygon.normals[i].cast<double>();
  }
  Manifold<double> manifold = clipped(placed);
  for (auto& point : manifold.points) point.position *= placed.local_per_world;
  return manifold;
}

/// Vertices as they stand, rotations made unit; figures are those of the world, or of A's frame.
template <bool in_world>
Answer by_unit_rotations(const PairCase& pair) {
  Placed placed = clipping::placed_pair<double>(pair);
  placed.a = polygon_cast<double>(pair.a.polygon);
  placed.b = polygon_cast<double>(pair.b.polygon);
  Manifold<double> manifold = clipped(placed);
  for (int i = 0; in_world && i < manifold.count; ++i) {
    Vector& position = manifold.points[i].position;
    position = to_local(pair.a.pose, transform(placed.pose_a, position));
  }
  return manifold;
}

/// The transpose of a rotation for its inverse, which costs as much as floats do.
Answer by_transposes(const PairCase& pair) {
  const auto pose = [](const Pose<float>& of) {
    return Pose<double>{of.position.cast<double>(), of.rotation.cast<double>()};
  };
  return clipped({polygon_cast<double>(pair.a.polygon), polygon_cast<double>(pair.b.polygon),
                  pose(pair.a.pose), pose(pair.b.pose)});
}

Answer rounded_to_float(const PairCase& pair) {
  static const Collider right = make_clip64();
  const auto manifold = std::get<Manifold<double>>(right.collide(pair));
  return manifold_cast<double>(manifold_cast<float>(manifold));
}

/// The decimals of a case's floats, read as doubles.
Answer by_decimals(const PairCase& pair) {
  const auto read = [](const Vector2<float>& v) {
    const auto as_double = [](float value) {
      return std::strtod(fmt::format("{}", value).c_str(), nullptr);
    };
    return Vector(as_double(v.x()), as_double(v.y()));
  };
  Placed placed = clipping::placed_pair<double>(pair);
  const auto place = [&](const Body& body, ConvexPolygon<double>& polygon, Pose<double>& pose) {
    std::vector<Vector> vertices;
    for (const auto& v : body.polygon.corners()) vertices.push_back(read(v));
    polygon = make_polygon<double>(vertices, static_cast<double>(body.polygon.radius),
                                   body.polygon.rounding);
    pose = {read(body.pose.position), read(body.pose.rotation)};
  };
  place(pair.a, placed.a, placed.pose_a);
  place(pair.b, placed.b, placed.pose_b);
  return clipped(placed);
}

/// The article's clipping on vertices that are placed in the world first.
template <class Scalar>
Answer by_world_vertices(const PairCase& pair) {
  const auto in_world = [](const Body& body) -> std::optional<ConvexPolygon<Scalar>> {
    Pose<Scalar> pose{body.pose.position.cast<Scalar>(), body.pose.rotation.cast<Scalar>()};
    Scalar scale = 1;
    if constexpr (std::is_same_v<Scalar, double>) pose.rotation /= scale = pose.rotation.norm();
    std::vector<Vector2<Scalar>> vertices;
    std::vector<Vector> exactly;
    for (const auto& v : body.polygon.corners()) {
      vertices.push_back(transform<Scalar>(pose, scale * v.template cast<Scalar>()));
      exactly.push_back(vertices.back().template cast<double>());
    }
    if (find_defect_in_doubles(exactly)) return std::nullopt;
    return make_polygon<Scalar>(vertices, static_cast<Scalar>(body.polygon.radius));
  };
  const auto a = in_world(pair.a);
  const auto b = in_world(pair.b);
  if (!a || !b) return Unsupported{"no polygon is left in the world"};
  auto manifold = manifold_cast<double>(clipping::collide_in_frame(*a, *b));
  manifold.normal = local_normal(pair, manifold.normal);
  for (int i = 0; i < manifold.count; ++i) {
    manifold.points[i].position = to_local(pair.a.pose, manifold.points[i].position);
  }
  return manifold;
}

template <class Scalar>
Collider small_engine() {
  Declaration declaration{.name = "mistaken",
                          .version = "1",
                          .description = "a small engine",
                          .frame = RoundingFrame::world};
  if (std::is_same_v<Scalar, double>) declaration.scalar = ScalarType::float64;
  return asking(declaration, by_world_vertices<Scalar>);
}

}  // namespace

std::vector<MistakenAdapter> mistaken_in_reading() {
  const Collider clip = make_clip();
  const Collider clip64 = make_clip64();
  Declaration as_float = clip.declaration;
  as_float.name = "mistaken";
  return {
      {"float-normals", "in double by normals that are floats",
       asking(in_double(), by_float_normals)},
      {"unit-rotation", "rotations are made unit, figures of the world",
       asking(in_double(), by_unit_rotations<true>)},
      {"unit-rotation", "rotations are made unit, figures of A's frame",
       asking(in_double(), by_unit_rotations<false>)},
      {"float-figures", "a transpose for an inverse", asking(in_double(), by_transposes)},
      {"float-figures", "answers are rounded to float", asking(in_double(), rounded_to_float)},
      {"float-figures", "it computes in float", asking(in_double(), clip.collide)},
      {"decimals-as-doubles", "decimals are read as doubles, and float is declared",
       asking(as_float, by_decimals)},
      {"undeclared-world-vertices", "normals of world vertices in float", small_engine<float>()},
      {"undeclared-world-vertices", "normals of world vertices in double", small_engine<double>()},
      {"degrees", "degrees for radians, in float", asked_about(clip, turned<1, 0>, true)},
      {"degrees", "degrees for radians, in double, in A's frame",
       asked_about(clip64, turned<1, 0>, false)},
      {"degrees", "radians for degrees, in float", asked_about(clip, turned<0, 1>, true)},
      {"degrees", "radians for degrees, in A's frame", asked_about(clip, turned<0, 1>, false)},
      {"rotation-backwards", "turned the other way", asked_about(clip, turned_backwards, true)},
      {"rotation-backwards", "turned the other way, in A's frame",
       asked_about(clip64, turned_backwards, false)},
      {"y-down", "vertices flipped in their own frames", asked_about(clip64, flipped, true)},
      {"radius-left-out", "radii are not handed on", asked_about(clip, with_radii_times<0>, true)},
      {"radius-twice", "radii are handed on twice", asked_about(clip, with_radii_times<2>, true)},
  };
}

}  // namespace manifuzz::test
