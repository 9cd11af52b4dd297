#include "methods/perturbed.hpp"

#include "methods/closest_points.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

template <class Scalar>
Answer perturbed_closest_points(const PairCase& pair, Scalar) {
  return own::answer_of<Scalar>(pair, [](const auto& a, const auto& b, const Pose<Scalar>& b_in_a) {
    // Turned a little, shapes are nearest about where they were.
    methods::Simplex hint;
    return methods::contact_by_perturbing(
        a, b, b_in_a, [&hint](const auto& p, const auto& q, const Pose<Scalar>& q_in_p) {
          return methods::contact_by_gjk(p, q, q_in_p, hint).manifold;
        });
  });
}

template <class Scalar>
Collider of_perturbed(std::string name, std::string description) {
  Collider collider = own::collider_of<Scalar>({.name = std::move(name),
                                                .version = MANIFUZZ_VERSION,
                                                .description = std::move(description),
                                                .clips = false,
                                                .one_point_enough = true},
                                               perturbed_closest_points<Scalar>, nullptr);
  collider.in_double = make_perturbed64;  // collider_of has clip64
  return collider;
}

}  // namespace

Collider make_perturbed() {
  return of_perturbed<float>("perturbed",
                             "gjk, asked again with one shape turned a little each way, in float");
}

Collider make_perturbed64() {
  return of_perturbed<double>(
      "perturbed64", "gjk64, asked again with one shape turned a little each way, in double");
}

}  // namespace manifuzz
