// Copied with the bugs of round shapes planted into the collider, and compiled under a namespace of
// theirs.
#include "canary/planted.hpp"
#include "own_colliders/clip.cpp"

namespace manifuzz {
namespace {

/// `clip` with a second point of round shapes by this policy.
Collider with_second_point(SecondPoint second_point) {
  Collider collider = make_clip();
  collider.declaration.name += " by a policy";
  collider.declaration.second_point = second_point;
  collider.collide = [second_point](const PairCase& pair) {
    return answer<float>(pair, [&](const auto& placed, const Pose<float>& b_in_a) {
      return clipping::collide(placed.a, placed.b, b_in_a, 0.0F, second_point);
    });
  };
  return collider;
}

[[maybe_unused]] const bool planted =
    canary::add_round_colliders({PLANTED_BUGS}, make_clip, with_second_point);

}  // namespace
}  // namespace manifuzz
