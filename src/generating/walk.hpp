#pragma once

#include <span>
#include <string_view>

#include "base/random.hpp"
#include "generating/placing.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// How one pair moves through a random walk: B over a face of A, or all round A. Every quantity
/// goes up or down by up to its step each frame, and turns back at its ends. Lengths are world
/// lengths, the polygons being 1 to 3 across.
struct Walk {
  std::string_view name;
  std::string_view description;  ///< one line for `list sweeps`
  int count_a = 4;
  int count_b = 4;
  double gap_low = 0;
  double gap_high = 0;
  double gap_step = 0;
  double aside_max = 0;  ///< along A's face
  double aside_step = 0;
  double tilt_max = 0;  ///< the tangent of the angle between both faces
  double tilt_step = 0;
  double turn_step = 0;  ///< the tangent of B's turn, and of its way round A, without an end
};

std::span<const Walk> walks();
const Walk* find_walk(std::string_view name);

/// The frames of a walk, which depend on (seed, the walk's name) alone.
class Walker {
 public:
  Walker(std::uint64_t seed, const Walk& walk);
  PairCase next();

 private:
  double moved(double at, double step, double low, double high);

  const Walk& walk_;
  Random random_;
  PairCase pair_;  ///< B at its last place
  Vector2<double> rotation_a_;
  Vector2<double> turn_{1, 0};     ///< of B, against A
  Vector2<double> heading_{0, 1};  ///< from A to B, in A's frame
  double gap_ = 0;
  double aside_ = 0;
  double tilt_ = 0;
};

/// Frame `index` of a walk.
PairCase frame_of(std::uint64_t seed, const Walk& walk, std::uint64_t index);

}  // namespace manifuzz
