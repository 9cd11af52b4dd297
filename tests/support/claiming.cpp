#include "support/claiming.hpp"

#include <algorithm>

#include "clipping/collide.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz::test {
namespace {

/// In the world; rotations made unit where the scalar can tell.
template <class Scalar>
ConvexPolygon<Scalar> placed(const Body& body) {
  const Pose<Scalar> pose{body.pose.position.cast<Scalar>(), body.pose.rotation.cast<Scalar>()};
  ConvexPolygon<Scalar> polygon = transform(pose, polygon_cast<Scalar>(body.polygon));
  if constexpr (std::is_same_v<Scalar, double>) {
    const double unit = std::sqrt(pose.rotation.dot(pose.rotation));
    for (int i = 0; i < polygon.count; ++i) polygon.normals[i] /= unit;
  }
  return polygon;
}

template <class Scalar>
Manifold<double> clipped_in_world(const PairCase& pair) {
  auto manifold = manifold_cast<double>(
      clipping::collide_in_frame(placed<Scalar>(pair.a), placed<Scalar>(pair.b)));
  if (manifold.count == 0) return manifold;
  manifold.normal = local_normal(pair, manifold.normal);
  for (int i = 0; i < manifold.count; ++i) {
    manifold.points[i].position = to_local(pair.a.pose, manifold.points[i].position);
  }
  return manifold;
}

Declaration as_separation(Declaration declaration) {
  declaration.claims = Claims::separation;
  return declaration;
}

Declaration as_touching(Declaration declaration) {
  declaration.claims = Claims::touching;
  return declaration;
}

template <PointsAt points>
Declaration as_point(Declaration declaration) {
  declaration.claims = Claims::point;
  declaration.points = points;
  return declaration;
}

template <PointsAt points>
Declaration as_unclipped(Declaration declaration) {
  declaration.clips = false;
  declaration.points = points;
  return declaration;
}

Declaration with_shared_depth(Declaration declaration) {
  declaration.clips = false;
  declaration.shares_depth = true;
  return declaration;
}

Manifold<double> deepest_alone(Manifold<double> manifold) {
  if (manifold.count == 2 && manifold.points[1].depth > manifold.points[0].depth) {
    manifold.points[0] = manifold.points[1];
  }
  manifold.count = std::min(manifold.count, 1);
  return manifold;
}

/// From the incident edge to its skin, and that share of the way to the reference skin.
Manifold<double> moved(const PairCase& pair, Manifold<double> manifold, double share) {
  const double unit = pair.a.pose.rotation.cast<double>().norm();
  const bool is_on_skin = is_round(pair);
  const auto radius =
      is_on_skin ? 0 : static_cast<double>(pair[other(manifold.reference)].polygon.radius);
  const double out_of_b = manifold.reference == Side::a ? 1 : -1;
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint<double>& point = manifold.points[i];
    point.position += out_of_b * (share * point.depth - radius) / unit * manifold.normal;
  }
  return manifold;
}

Answer touching_alone(const PairCase&, const Manifold<double>& manifold) {
  return Penetration{.touches = manifold.count > 0, .normal = {}};
}

Answer translation(const PairCase&, const Manifold<double>& manifold) {
  Penetration result{.touches = manifold.count > 0, .normal = {}};
  if (!result.touches) return result;
  result.normal = manifold.normal;
  result.depth = deepest_alone(manifold).points[0].depth;
  return result;
}

template <Side side>
Answer on_surface(const PairCase& pair, const Manifold<double>& manifold) {
  const Manifold<double> deepest = deepest_alone(manifold);
  return moved(pair, deepest, manifold.reference == side ? 1 : 0);
}

Answer of_deepest(const PairCase&, const Manifold<double>& manifold) {
  return deepest_alone(manifold);
}

Answer whole_clip(const PairCase&, const Manifold<double>& manifold) {
  return manifold;
}

Answer at_midpoints(const PairCase& pair, const Manifold<double>& manifold) {
  return moved(pair, manifold, 0.5);
}

Answer sharing_depth(const PairCase&, const Manifold<double>& clip) {
  Manifold<double> manifold = clip;
  const double depth = deepest_alone(manifold).points[0].depth;
  for (int i = 0; i < manifold.count; ++i) manifold.points[i].depth = depth;
  return manifold;
}

constexpr Claim kClaims[] = {
    {"touching", as_touching, touching_alone},
    {"separation", as_separation, translation},
    {"a point on A", as_point<PointsAt::surface_a>, on_surface<Side::a>},
    {"a point on B", as_point<PointsAt::surface_b>, on_surface<Side::b>},
    {"a point of either", as_point<PointsAt::clip>, of_deepest},
    {"points of a clip", as_unclipped<PointsAt::clip>, whole_clip},
    {"midpoints", as_unclipped<PointsAt::midpoint>, at_midpoints},
    {"points of one depth", with_shared_depth, sharing_depth},
};

}  // namespace

std::string name_of(const Claiming& claiming) {
  const bool narrow = claiming.scalar == ScalarType::float32;
  const bool in_world = claiming.frame == RoundingFrame::world;
  return std::string(narrow ? "float" : "double") + (in_world ? ", world" : ", local");
}

Manifold<double> clipped(const PairCase& pair, const Claiming& claiming) {
  static const Collider clip = make_clip();
  static const Collider clip64 = make_clip64();
  const bool narrow = claiming.scalar == ScalarType::float32;
  if (claiming.frame == RoundingFrame::world) {
    return narrow ? clipped_in_world<float>(pair) : clipped_in_world<double>(pair);
  }
  return std::get<Manifold<double>>((narrow ? clip : clip64).collide(pair));
}

std::span<const Claim> claims() {
  return kClaims;
}

Declaration declaration_of(const Claiming& claiming) {
  Declaration declaration;
  declaration.name = name_of(claiming);
  declaration.scalar = claiming.scalar;
  declaration.frame = claiming.frame;
  return declaration;
}

}  // namespace manifuzz::test
