#pragma once

#include <cmath>
#include <type_traits>

#include "collider/collider.hpp"
#include "collider/sequence_collider.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

namespace clipping {

/// A pair as the algorithm takes it: polygons of one length unit, poses of unit rotation.
template <class Scalar>
struct PlacedPair {
  ConvexPolygon<Scalar> a;
  ConvexPolygon<Scalar> b;
  Pose<Scalar> pose_a;
  Pose<Scalar> pose_b;
  Scalar local_per_world = 1;  ///< A's local length of one world length
};

/// A stored rotation (cos, sin) of length k turns by its direction and scales by k: the polygon is
/// scaled, and the rest is rigid.
inline PlacedPair<double> placed_pair_scaled(const ConvexPolygon<double>& a,
                                             const ConvexPolygon<double>& b,
                                             const Pose<double>& pose_a,
                                             const Pose<double>& pose_b) {
  PlacedPair<double> placed{a, b, pose_a, pose_b};
  const auto scale = [](ConvexPolygon<double>& polygon, Pose<double>& pose) {
    const double k = std::sqrt(pose.rotation.dot(pose.rotation));
    for (int i = 0; i < polygon.count; ++i) polygon.vertices[i] *= k;
    pose.rotation = unit_direction(pose.rotation);
    return k;
  };
  placed.local_per_world = 1 / scale(placed.a, placed.pose_a);
  scale(placed.b, placed.pose_b);
  return placed;
}

/// A pair of floats likewise.
inline PlacedPair<double> placed_pair_scaled(const PairCase& pair) {
  const auto pose_of = [](const Body& body) -> Pose<double> {
    return {body.pose.position.cast<double>(), body.pose.rotation.cast<double>()};
  };
  return placed_pair_scaled(polygon_cast<double>(pair.a.polygon),
                            polygon_cast<double>(pair.b.polygon), pose_of(pair.a), pose_of(pair.b));
}

/// The pair for a collider of this scalar, float or double: in float as it stands, its rotations
/// are taken to be unit.
template <class Scalar>
PlacedPair<Scalar> placed_pair(const PairCase& pair) {
  if constexpr (std::is_same_v<Scalar, float>) {
    return {pair.a.polygon, pair.b.polygon, pair.a.pose, pair.b.pose, 1};
  } else {
    return placed_pair_scaled(pair);
  }
}

/// A placed pair of floats that stay where they are: it must not outlive the pair.
struct PlacedFloats {
  const ConvexPolygon<float>& a;
  const ConvexPolygon<float>& b;
  const Pose<float>& pose_a;
  const Pose<float>& pose_b;
  float local_per_world = 1;
};

/// For one call: of floats nothing is copied.
template <class Scalar>
auto placed_where_it_is(const PairCase& pair) {
  if constexpr (std::is_same_v<Scalar, float>) {
    return PlacedFloats{pair.a.polygon, pair.b.polygon, pair.a.pose, pair.b.pose};
  } else {
    return placed_pair<Scalar>(pair);
  }
}

}  // namespace clipping

/// The article in float: transposes for inverses, so the rotation's defect is part of its error.
Collider make_clip(double tie_bias = 0);

/// The article in double, on the same floats: divides where a rotation is not quite unit.
Collider make_clip64(double tie_bias = 0);

/// The kernel for one pair: `clip`'s manifolds, bit for bit.
Collider make_pair(double tie_bias = 0);

/// The kernel for many pairs, asked one at a time: `clip`'s manifolds, bit for bit.
Collider make_batch(double tie_bias = 0);

/// Makes `batch64`, the kernel in double: `clip64`'s manifolds, bit for bit.
Collider make_batch64(double tie_bias = 0);

/// One point by the closest points of the cores, in float; judged by the penetration curve.
Collider make_gjk();

/// Makes `gjk64`, which is `gjk` in double.
Collider make_gjk64();

/// Makes a `gjk` that shrinks polygons first, as the article does; answers have the shapes used.
Collider make_gjk_shrunk();

/// The pair as `gjk-shrunk` has it: polygons shrunk by a quarter of their inradius.
PairCase shrunk_pair(const PairCase& pair);

/// Clipping, with the faces by GJK and EPA; polygons alone.
Collider make_gjk_clip();

/// `gjk` asked up to twice more, with one shape turned a little each way; up to two points.
Collider make_perturbed();

/// Makes `perturbed64`, which is `perturbed` in double.
Collider make_perturbed64();

/// Any collider asked so that answers with one point; mapped back and measured in double.
Collider make_perturbed_over(const Collider& base);

/// Points of `gjk` kept over frames, in float; hints are kept too.
SequenceCollider make_cached();

/// Points of `gjk64` kept over frames, in double.
SequenceCollider make_cached64();

/// Points of `gjk` kept by Bullet's rules.
SequenceCollider make_cached_bullet();

/// Points of any collider that claims one (`Claims::point`) and alters no shapes, kept over frames
/// in double; named cached+NAME.
SequenceCollider cached_over(const Collider& one_point);

/// Keeps such points by Bullet's rules; named cached-bullet+NAME.
SequenceCollider cached_bullet_over(const Collider& one_point);

// A namespace of its own, as clipping has, keeps planted copies apart.
namespace own {

/// What `contact(a, b, b_in_a)` makes of a pair, a manifold in the scalar, as an answer.
template <class Scalar, class Contact>
Answer answer_of(const PairCase& pair, const Contact& contact) {
  const auto placed = clipping::placed_pair<Scalar>(pair);
  Manifold<Scalar> manifold =
      contact(placed.a, placed.b, relative_pose(placed.pose_a, placed.pose_b));
  for (int i = 0; i < manifold.count; ++i) manifold.points[i].position *= placed.local_per_world;
  return manifold_cast<double>(manifold);
}

/// What all of these have in common: `collide_one(pair, bias)` gives the answers, in the scalar.
template <class Scalar, class CollideOne>
Collider collider_of(const Declaration& declaration, CollideOne collide_one,
                     Collider (*with_tie_bias)(double tie_bias)) {
  const auto bias = static_cast<Scalar>(declaration.tie_bias.absolute);
  Collider collider;
  collider.declaration = declaration;
  collider.declaration.scalar =
      std::is_same_v<Scalar, float> ? ScalarType::float32 : ScalarType::float64;
  collider.declaration.tie_bias.absolute = static_cast<double>(bias);
  collider.collide = [collide_one, bias,
                      takes_round = declaration.takes_round](const PairCase& pair) -> Answer {
    if (is_round(pair) && !takes_round) return Unsupported{"takes no round shapes"};
    return collide_one(pair, bias);
  };
  collider.with_tie_bias = with_tie_bias;
  collider.in_double = [bias] { return make_clip64(static_cast<double>(bias)); };
  return collider;
}

}  // namespace own

}  // namespace manifuzz
