#pragma once

#include <cstddef>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// Where both bodies of a sequence stand in one frame, in the world.
struct FramePoses {
  Pose<float> a;
  Pose<float> b;

  friend bool operator==(const FramePoses&, const FramePoses&) = default;
};

/// Two shapes and how they move: the case of whoever keeps something from frame to frame. There is
/// at least one frame.
struct Sequence {
  ConvexPolygon<float> a;  ///< in its own frame
  ConvexPolygon<float> b;
  std::vector<FramePoses> frames;

  /// The pair as it stands in a frame, from 0.
  PairCase at(std::size_t frame) const { return {{a, frames[frame].a}, {b, frames[frame].b}}; }
  friend bool operator==(const Sequence&, const Sequence&) = default;
};

}  // namespace manifuzz
