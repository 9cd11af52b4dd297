#pragma once

#include <limits>

#include "methods/epa.hpp"
#include "methods/nearest_faces.hpp"

namespace manifuzz::methods {

/// A face and the other core's deepest vertex, as a simplex.
template <class Scalar>
Simplex simplex_of(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                   const FoundFace<Scalar>& face) {
  const auto index = [](int i) { return static_cast<unsigned char>(i); };
  const auto [side, found] = face;
  const unsigned char deepest = index(found.deepest);
  const unsigned char first = index(found.face);
  if (side == Side::a) {
    return {{{{first, deepest}, {index(a.next(found.face)), deepest}, {}}}, 2};
  }
  return {{{{deepest, first}, {deepest, index(b.next(found.face))}, {}}}, 2};
}

/// Where two cores in one frame are nearest, or overlap least.
template <class Scalar>
struct NearestFeatures {
  Apartness apartness = Apartness::separated;  ///< if farther than the total radius, nothing more
  NearestFaces<Scalar> faces;                  ///< at that feature
  clipping::NearestPlaces<Scalar> vertices;    ///< of cores that are apart: one of its vertices
  int gjk_iterations = 0;                      ///< supports that GJK asked for
  int epa_iterations = 0;                      ///< supports that EPA asked for
};

/// The vertices at which walks from those of a feature of 1 or 2 end, the nearest. From one end
/// alone, a walk may stop short of the other: just inside the edge by rounding, and it is far away.
template <class Scalar>
clipping::NearestPlaces<Scalar> nearest_from(const ConvexPolygon<Scalar>& a,
                                             const ConvexPolygon<Scalar>& b,
                                             const Simplex& feature) {
  const auto walk_from = [&](SupportPair p) { return clipping::walk_nearer(a, p.a, b, p.b); };
  const auto of_first = walk_from(feature.vertices[0]);
  if (feature.count == 1) return of_first;
  const auto of_last = walk_from(feature.vertices[1]);
  return clipping::squared_length(of_last.apart) < clipping::squared_length(of_first.apart)
             ? of_last
             : of_first;
}

/// By GJK, and where they overlap by EPA. `hint` is what the last step left, and is left for the
/// next one: where a face separates mitred skins, that face.
template <class Scalar>
NearestFeatures<Scalar> nearest_features(const ConvexPolygon<Scalar>& a,
                                         const ConvexPolygon<Scalar>& b, Simplex& hint) {
  const Scalar total_radius = a.radius + b.radius;
  // Mitred skins reach past their cores' corners by more than they are thick.
  const bool is_limited = total_radius == 0 || are_round(a, b);
  const double limit = is_limited ? static_cast<double>(a.radius) + static_cast<double>(b.radius)
                                  : std::numeric_limits<double>::infinity();
  const GjkResult found = gjk(a, b, hint, limit);
  hint = found.simplex;
  NearestFeatures<Scalar> nearest;
  nearest.apartness = found.apartness;
  nearest.gjk_iterations = found.iterations;
  if (found.apartness == Apartness::separated) return nearest;
  Simplex feature = found.simplex;
  Vector2<double> to_feature = found.direction;
  if (found.apartness == Apartness::overlapping) {
    const EpaResult expanded = epa(a, b, found.simplex);
    nearest.epa_iterations = expanded.iterations;
    feature = expanded.edge;
    to_feature = expanded.inward;
  } else {
    nearest.vertices = nearest_from(a, b, feature);
    const auto& [of_a, of_b] = nearest.vertices.features;
    if (feature.count == 1) {
      feature.vertices[0] = {of_a.index, of_b.index};
      to_feature = Difference<Scalar>(a, b).vertex(feature.vertices[0]);
    }
  }
  nearest.faces = nearest_faces(a, b, feature, to_feature);
  if (!are_round(a, b) && nearest.faces.separation() > total_radius) {
    nearest.apartness = Apartness::separated;
    hint = simplex_of(a, b, nearest.faces.greatest());
  }
  return nearest;
}

}  // namespace manifuzz::methods
