#include "campaign/hints/reading_mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include <fmt/format.h>

namespace manifuzz {
namespace {

using Vector = Vector2<double>;

/// A body as a collider saw it.
struct SeenBody {
  UsedVertices vertices;
  Pose<double> pose;
};

SeenBody seen(const Body& body) {
  SeenBody as_is{.vertices = {.all = {}, .count = body.polygon.count},
                 .pose = {body.pose.position.cast<double>(), body.pose.rotation.cast<double>()}};
  for (int i = 0; i < body.polygon.count; ++i) {
    as_is.vertices.all[i] = body.polygon.vertices[i].cast<double>();
  }
  if (body.polygon.is_round()) as_is.vertices.round_radius = body.polygon.radius;
  return as_is;
}

using See = std::function<SeenBody(const Body&)>;

/// Where B's point lies in A's frame, of poses as they were seen.
Vector to_frame_of_a(const Pose<double>& a, const Pose<double>& b, const Vector& point) {
  return rotate_inverse<double>(a.rotation,
                                rotate<double>(b.rotation, point) + (b.position - a.position));
}

/// The vertices, in the body's true frame, that are in the world where they were seen.
UsedVertices in_true_frame(const Body& body, const SeenBody& as_seen) {
  const SeenBody truly = seen(body);
  UsedVertices used = as_seen.vertices;
  for (int i = 0; i < used.count; ++i) {
    used.all[i] = rotate_inverse<double>(truly.pose.rotation,
                                         rotate<double>(as_seen.pose.rotation, used.all[i]) +
                                             (as_seen.pose.position - truly.pose.position));
  }
  return used;
}

/// B's vertices in its own frame as it is; they were seen in A's frame as it was taken.
UsedVertices in_true_frame_of_b(const PairCase& pair, const SeenBody& a, const SeenBody& b) {
  const Pose<double> true_a = seen(pair.a).pose;
  const Pose<double> true_b = seen(pair.b).pose;
  UsedVertices used = b.vertices;
  for (int i = 0; i < used.count; ++i) {
    const Vector in_a = to_frame_of_a(a.pose, b.pose, used.all[i]);
    used.all[i] = rotate_inverse<double>(true_b.rotation, rotate<double>(true_a.rotation, in_a) +
                                                              (true_a.position - true_b.position));
  }
  return used;
}

/// The answer, about these shapes in place of the case's; none where it has some already, or gave
/// none at all.
MaybeUndone about(const UsedShapes& shapes, const AskedCase& asked) {
  Undone undone{asked.declaration, asked.answer};
  undone.declaration.alters_shapes = true;
  if (used_by(asked.answer) != nullptr) return std::nullopt;
  if (const auto* const whole = std::get_if<Manifold<double>>(&asked.answer)) {
    undone.answer = PartialManifold{
        .manifold = *whole, .names_reference = true, .names_features = true, .used = shapes};
  } else if (auto* const partial = std::get_if<PartialManifold>(&undone.answer)) {
    partial->used = shapes;
  } else if (auto* const less = std::get_if<Penetration>(&undone.answer)) {
    less->used = shapes;
  } else {
    return std::nullopt;
  }
  return undone;
}

MaybeUndone as_seen_in_world(const See& see, const AskedCase& asked) {
  const PairCase& pair = asked.pair();
  return about({in_true_frame(pair.a, see(pair.a)), in_true_frame(pair.b, see(pair.b))}, asked);
}

/// Where A's rotation was seen as of another length, a double one's frame is A's as it was seen, so
/// that a length there is one in the world; the bounds of float allow for the difference.
MaybeUndone as_seen_in_frame_of_a(const See& see, const AskedCase& asked) {
  PairCase pair = asked.pair();
  const SeenBody a = see(pair.a);
  const SeenBody b = see(pair.b);
  const bool is_rescaled = a.pose.rotation.norm() != seen(pair.a).pose.rotation.norm();
  if (is_rescaled && asked.declaration.scalar == ScalarType::float64) {
    pair.a.pose.rotation = {1, 0};
    pair.b.pose = pair.a.pose;
  }
  MaybeUndone undone = about({a.vertices, in_true_frame_of_b(pair, a, b)}, asked);
  if (undone) undone->pair = pair;
  return undone;
}

MaybeUndone as_seen(const See& see, SeenFrom from, const AskedCase& asked) {
  return from == SeenFrom::world ? as_seen_in_world(see, asked) : as_seen_in_frame_of_a(see, asked);
}

/// Judges by angles, whose digits may be rounded by so much.
MaybeUndone by_angles(MaybeUndone undone, double within) {
  if (!undone) return undone;
  undone->declaration.takes_angles = true;
  undone->within = within;
  return undone;
}

}  // namespace

MaybeUndone with_unit_rotations(SeenFrom from, const AskedCase& asked) {
  const auto see = [](const Body& body) {
    SeenBody unit = seen(body);
    unit.pose.rotation /= unit.pose.rotation.norm();
    return unit;
  };
  return by_angles(as_seen(see, from, asked), 0);
}

MaybeUndone with_rotations_backwards(SeenFrom from, const AskedCase& asked) {
  const auto see = [](const Body& body) {
    SeenBody backwards = seen(body);
    backwards.pose.rotation.y() *= -1;
    return backwards;
  };
  return as_seen(see, from, asked);
}

MaybeUndone with_angles_times(double factor, SeenFrom from, const AskedCase& asked) {
  const auto see = [factor](const Body& body) {
    SeenBody turned = seen(body);
    const Vector& rotation = turned.pose.rotation;
    const double angle = factor * std::atan2(rotation.y(), rotation.x());
    turned.pose.rotation = {std::cos(angle), std::sin(angle)};
    return turned;
  };
  // An angle of a float that is taken 57 times as large has lost as many of its digits.
  constexpr double kWithin = 1e-4;
  return by_angles(as_seen(see, from, asked), kWithin);
}

MaybeUndone with_vertices_flipped(const AskedCase& asked) {
  const auto see = [](const Body& body) {
    SeenBody flipped = seen(body);
    UsedVertices& vertices = flipped.vertices;
    for (Vector& vertex : vertices.all) vertex.y() *= -1;
    std::reverse(vertices.all.begin(), vertices.all.begin() + vertices.count);
    return flipped;
  };
  MaybeUndone undone = as_seen(see, SeenFrom::world, asked);
  if (!undone) return undone;
  if (auto* const partial = std::get_if<PartialManifold>(&undone->answer)) {
    partial->names_features = false;  // vertices are numbered the other way round
  }
  return undone;
}

MaybeUndone with_decimals_as_doubles(SeenFrom from, const AskedCase& asked) {
  if (asked.declaration.scalar == ScalarType::float64) return std::nullopt;
  const auto as_double = [](float value) {
    return std::strtod(fmt::format("{}", value).c_str(), nullptr);
  };
  const auto both = [&](const Vector2<float>& v) {
    return Vector(as_double(v.x()), as_double(v.y()));
  };
  const auto see = [&](const Body& body) {
    SeenBody read = seen(body);
    for (int i = 0; i < body.polygon.count; ++i) {
      read.vertices.all[i] = both(body.polygon.vertices[i]);
    }
    read.pose = {both(body.pose.position), both(body.pose.rotation)};
    return read;
  };
  return as_seen(see, from, asked);
}

MaybeUndone with_radii_times(float factor, const AskedCase& asked) {
  PairCase pair = asked.pair();
  if (total_radius(pair) == 0) return std::nullopt;
  UsedShapes shapes;
  for (const Side side : {Side::a, Side::b}) {
    ConvexPolygon<float>& polygon = pair[side].polygon;
    shapes[side] = seen(pair[side]).vertices;
    if (polygon.is_round()) {
      // A circle has a radius, or is nothing.
      constexpr float kLeast = 1e-30F;
      shapes[side].round_radius = std::max(factor * polygon.radius, kLeast);
    } else {
      polygon.radius *= factor;
    }
  }
  MaybeUndone undone =
      is_round(pair) ? about(shapes, asked) : Undone{asked.declaration, asked.answer};
  if (undone) undone->pair = pair;
  return undone;
}

}  // namespace manifuzz
