#pragma once

#include "base/random.hpp"
#include "generating/drafts.hpp"
#include "geometry/pose.hpp"

// How bodies of a model move: each a function of a seed.

namespace manifuzz::test {

inline Random motion(std::uint64_t seed) {
  return Random(seed, "scene motion", 0);
}

inline Pose<float> anywhere(std::uint64_t seed) {
  Random random = motion(seed);
  const double x = random.uniform(-3, 3);
  const double y = random.uniform(-3, 3);
  return {Vector2<double>(x, y).cast<float>(), random_direction(random).cast<float>()};
}

/// A step of any length from 1e-6 on.
inline Pose<float> shifted(Pose<float> pose, std::uint64_t seed) {
  Random random = motion(seed);
  const double length = random.magnitude(-20, -1);
  pose.position += (length * random_direction(random)).cast<float>();
  return pose;
}

inline Pose<float> turned(Pose<float> pose, std::uint64_t seed) {
  Random random = motion(seed);
  const double t = random.either_sign(random.magnitude(-20, -2));
  pose.rotation = unit(rotate<double>(turn_by(t), pose.rotation.cast<double>())).cast<float>();
  return pose;
}

/// Exactly, whatever the rotation.
inline Pose<float> quarter_turned(Pose<float> pose) {
  pose.rotation = {-pose.rotation.y(), pose.rotation.x()};
  return pose;
}

inline Pose<float> stepped_by_one_ulp(Pose<float> pose, std::uint64_t seed) {
  Random random = motion(seed);
  const int which = random.integer(0, 3);
  const int by = random.chance(0.5) ? 1 : -1;
  float& number = which < 2 ? pose.position[which] : pose.rotation[which - 2];
  const float before = number;
  number = stepped(number, by);
  if (!is_unit_rotation(pose.rotation)) number = before;
  return pose;
}

/// A share of the way to another place.
inline Pose<float> nearer(Pose<float> pose, const Vector2<float>& to, std::uint64_t seed) {
  Random random = motion(seed);
  const auto share = static_cast<float>(random.magnitude(-6, -1));
  pose.position += share * (to - pose.position);
  return pose;
}

}  // namespace manifuzz::test
