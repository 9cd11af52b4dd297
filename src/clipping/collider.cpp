#include "clipping/collider.hpp"

#include "clipping/collide.hpp"

namespace manifuzz {
namespace {

/// A pair as the algorithm takes it: polygons of one length unit, and B's pose in A's frame.
template <class Scalar>
struct Placed {
  ConvexPolygon<Scalar> a;
  ConvexPolygon<Scalar> b;
  Pose<Scalar> b_in_a;
  Scalar local_per_world = 1;  ///< A's local length of one world length
};

Placed<float> place_float(const PairCase& pair) {
  return {pair.a.polygon, pair.b.polygon, relative_pose(pair.a.pose, pair.b.pose), 1};
}

/// A stored (cos, sin) of length k turns by its direction and scales by k: scale the polygon, and
/// the rest is rigid.
ConvexPolygon<double> scaled_to_world(const Body& body, double k) {
  ConvexPolygon<double> polygon = polygon_cast<double>(body.polygon);
  for (int i = 0; i < polygon.count; ++i) polygon.vertices[i] *= k;
  return polygon;
}

Placed<double> place_double(const PairCase& pair) {
  const Vector2<double> rotation_a = pair.a.pose.rotation.cast<double>();
  const Vector2<double> rotation_b = pair.b.pose.rotation.cast<double>();
  const double k_a = std::sqrt(rotation_a.dot(rotation_a));
  const double k_b = std::sqrt(rotation_b.dot(rotation_b));
  const Pose<double> a{pair.a.pose.position.cast<double>(), rotation_a / k_a};
  const Pose<double> b{pair.b.pose.position.cast<double>(), rotation_b / k_b};
  return {scaled_to_world(pair.a, k_a), scaled_to_world(pair.b, k_b), relative_pose(a, b), 1 / k_a};
}

template <class Scalar>
Answer answer(Manifold<Scalar> manifold, Scalar local_per_world) {
  for (int i = 0; i < manifold.count; ++i) manifold.points[i].position *= local_per_world;
  return manifold_cast<double>(manifold);
}

template <class Scalar, class Place>
void implement(Collider& collider, Place place) {
  const auto bias = static_cast<Scalar>(collider.declaration.tie_bias);
  collider.collide = [place, bias](const PairCase& pair) {
    const Placed<Scalar> p = place(pair);
    return answer<Scalar>(clipping::collide(p.a, p.b, p.b_in_a, bias), p.local_per_world);
  };
  collider.from_normal = [place](const PairCase& pair, const Vector2<double>& normal) {
    const Placed<Scalar> p = place(pair);
    return answer<Scalar>(
        clipping::manifold_from_normal<Scalar>(p.a, p.b, p.b_in_a, normal.cast<Scalar>()),
        p.local_per_world);
  };
  collider.in_double = [bias] { return make_clip64(static_cast<double>(bias)); };
}

}  // namespace

Collider make_clip(double tie_bias) {
  Collider collider;
  collider.declaration = {
      .name = "clip",
      .version = MANIFUZZ_VERSION,
      .description =
          "the article's clipping in float, incident edge by least dot, no empty overlap",
      .scalar = ScalarType::float32,
      .frame = RoundingFrame::local,
      .tie_bias = static_cast<float>(tie_bias)};
  collider.with_tie_bias = make_clip;
  implement<float>(collider, place_float);
  return collider;
}

Collider make_clip64(double tie_bias) {
  Collider collider;
  collider.declaration = {.name = "clip64",
                          .version = MANIFUZZ_VERSION,
                          .description = "the same in double, on the same float input",
                          .scalar = ScalarType::float64,
                          .frame = RoundingFrame::local,
                          .tie_bias = tie_bias};
  collider.with_tie_bias = make_clip64;
  implement<double>(collider, place_double);
  return collider;
}

}  // namespace manifuzz
