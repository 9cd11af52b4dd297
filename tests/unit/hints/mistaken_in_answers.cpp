#include <cmath>

#include "own_colliders/own_colliders.hpp"
#include "unit/hints/mistaken_adapters.hpp"

namespace manifuzz::test {
namespace {

using Vector = Vector2<double>;
using Spoil = void (*)(const PairCase& pair, Manifold<double>& manifold);

/// Answers in float, as most adapters' colliders give them.
Collider spoilt(Spoil spoil) {
  Collider collider = make_clip();
  collider.declaration.name = "mistaken";
  collider.collide = [right = collider.collide, spoil](const PairCase& pair) {
    auto manifold = std::get<Manifold<double>>(right(pair));
    if (manifold.count > 0) spoil(pair, manifold);
    return Answer(manifold);
  };
  return collider;
}

void map_points(Manifold<double>& manifold, const auto& map) {
  for (int i = 0; i < manifold.count; ++i) {
    manifold.points[i].position = map(manifold.points[i].position, manifold.points[i].depth);
  }
}

void map_depths(Manifold<double>& manifold, const auto& map) {
  for (int i = 0; i < manifold.count; ++i) {
    manifold.points[i].depth = map(manifold.points[i].depth);
  }
}

/// Taken as it is given in a body's frame, as if that were the world.
Vector mistaken_place(const PairCase& pair, Side side, const Vector& position) {
  const Vector in_body = to_local(pair[side].pose, to_world(pair, position));
  return to_local(pair.a.pose, in_body);
}

Vector mistaken_direction(const PairCase& pair, Side side, const Vector& normal) {
  const Vector rotation = pair[side].pose.rotation.cast<double>();
  const Vector in_body = rotate_back<double>(rotation, world_normal(pair, normal));
  return local_normal(pair, in_body / rotation.norm());
}

template <Side side>
void in_frame_of(const PairCase& pair, Manifold<double>& m) {
  map_points(m, [&](const Vector& p, double) { return mistaken_place(pair, side, p); });
  m.normal = mistaken_direction(pair, side, m.normal);
}

/// From the incident core to the surface of that body.
template <Side side>
void on_surface_of(const PairCase& pair, Manifold<double>& m) {
  const Side incident = other(m.reference);
  const auto radius = static_cast<double>(pair[incident].polygon.radius);
  const double outwards = side == Side::a ? 1 : -1;
  const double core = is_round(pair) ? 0 : radius;
  const double unit = pair.a.pose.rotation.cast<double>().norm();
  map_points(m, [&](const Vector& p, double depth) {
    return Vector(p + (incident == side ? core : depth - core) * outwards / unit * m.normal);
  });
}

}  // namespace

std::vector<MistakenAdapter> mistaken_in_answers() {
  return {
      {"reversed-normal", "the normal points from B to A",
       spoilt([](const PairCase&, Manifold<double>& m) { m.normal = -m.normal; })},
      {"negative-depth", "depths are below zero", spoilt([](const PairCase&, Manifold<double>& m) {
         map_depths(m, [](double depth) { return -depth; });
       })},
      {"separation-as-depth", "depths are separations of cores",
       spoilt([](const PairCase& pair, Manifold<double>& m) {
         map_depths(m, [&](double depth) { return total_radius(pair) - depth; });
       })},
      {"radius-left-out", "depths leave the radii out",
       spoilt([](const PairCase& pair, Manifold<double>& m) {
         map_depths(m, [&](double depth) { return depth - total_radius(pair); });
       })},
      {"radius-twice", "depths have the radii twice",
       spoilt([](const PairCase& pair, Manifold<double>& m) {
         map_depths(m, [&](double depth) { return depth + total_radius(pair); });
       })},
      {"y-down", "y points down in positions and normals",
       spoilt([](const PairCase& pair, Manifold<double>& m) {
         const auto flipped = [](const Vector& v) { return Vector(v.x(), -v.y()); };
         map_points(m, [&](const Vector& p, double) {
           return to_local(pair.a.pose, flipped(to_world(pair, p)));
         });
         m.normal = local_normal(pair, flipped(world_normal(pair, m.normal)));
       })},
      {"frame-of-a", "positions and normals are in A's frame", spoilt(in_frame_of<Side::a>)},
      {"frame-of-b", "positions and normals are in B's frame", spoilt(in_frame_of<Side::b>)},
      {"frame-of-a", "positions alone are in A's frame",
       spoilt([](const PairCase& pair, Manifold<double>& m) {
         map_points(m, [&](const Vector& p, double) { return mistaken_place(pair, Side::a, p); });
       })},
      {"frame-of-a", "normals alone are in A's frame",
       spoilt([](const PairCase& pair, Manifold<double>& m) {
         m.normal = mistaken_direction(pair, Side::a, m.normal);
       })},
      {"world-as-local", "positions in the world are given as local ones",
       spoilt([](const PairCase& pair, Manifold<double>& m) {
         map_points(m, [&](const Vector& p, double) { return to_world(pair, p); });
       })},
      {"midpoints", "points lie halfway between both surfaces",
       spoilt([](const PairCase& pair, Manifold<double>& m) {
         const double inwards = m.reference == Side::a ? 1 : -1;
         const auto radius = static_cast<double>(pair[other(m.reference)].polygon.radius);
         const double core = is_round(pair) ? 0 : radius;
         const double unit = pair.a.pose.rotation.cast<double>().norm();
         map_points(m, [&](const Vector& p, double depth) {
           return Vector(p - inwards * (core - depth / 2) / unit * m.normal);
         });
       })},
      {"surface-of-a", "points lie on A's surface", spoilt(on_surface_of<Side::a>)},
      {"surface-of-b", "points lie on B's surface", spoilt(on_surface_of<Side::b>)},
      {"surface-of-reference", "points lie on the reference's surface",
       spoilt([](const PairCase& pair, Manifold<double>& m) {
         if (m.reference == Side::a) {
           on_surface_of<Side::a>(pair, m);
         } else {
           on_surface_of<Side::b>(pair, m);
         }
       })},
  };
}

Collider without_names(const Collider& collider) {
  Collider bare = collider;
  bare.collide = [right = collider.collide](const PairCase& pair) {
    Answer answer = right(pair);
    if (const auto* const whole = std::get_if<Manifold<double>>(&answer)) {
      return Answer(PartialManifold{.manifold = *whole});
    }
    return answer;
  };
  return bare;
}

}  // namespace manifuzz::test
