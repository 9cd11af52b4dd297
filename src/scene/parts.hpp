#pragma once

#include <cstdint>
#include <vector>

#include "scene/body.hpp"
#include "scene/rules.hpp"

namespace manifuzz::scene {

/// A shape of a body that has several, and where it stands in the body's frame. Two rotations that
/// are barely unit may make one that is not: the `composed` pose is held to the same tolerance.
struct BodyPart {
  std::uint32_t shape = 0;  ///< that was added
  Pose<float> pose;         ///< in the body's frame
};

/// A body, and the number of one of its parts.
struct PartName {
  BodyHandle body;         ///< which one
  std::uint32_t part = 0;  ///< from 0, in the order in which they were given

  friend bool operator==(const PartName&, const PartName&) = default;
};

/// What only some bodies have: rules, and parts. By a part's place in the scene.
struct Traits {
  Rules rules{};    ///< of its body
  PartName name{};  ///< whose part it is
};

/// A body of several parts: each has a place in the scene, the first the body's own.
struct Assembly {
  /// One of them.
  struct Part {
    BodyHandle handle;  ///< of its own place
    Pose<float> pose;   ///< in the body's frame
  };
  Pose<float> pose;         ///< in the world
  std::vector<Part> parts;  ///< in the order in which they were given
};

/// Where a frame stands that stands at `inner` in the frame at `outer`: rounded as `transform` is.
inline Pose<float> composed(const Pose<float>& outer, const Pose<float>& inner) {
  return {transform(outer, inner.position), rotate<float>(outer.rotation, inner.rotation)};
}

}  // namespace manifuzz::scene
