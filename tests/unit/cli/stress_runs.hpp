#pragma once

#include "support/run_program.hpp"

namespace manifuzz::test {

/// Few cases of two sweeps and a walk, and what else is asked.
inline Outcome run_small(const std::vector<std::string>& more) {
  return run_manifuzz(
      with({"stress", "--sweep", "distance", "--sweep", "collinear", "--sweep", "sliding",
            "--cases", "100", "--frames", "300", "--collider", "clip", "--collider", "box2d"},
           more));
}

/// Few cases of one sweep.
inline Outcome run_distance(const std::vector<std::string>& more) {
  return run_manifuzz(with({"stress", "--sweep", "distance", "--cases", "100", "--frames", "300",
                            "--collider", "box2d", "--collider", "clip"},
                           more));
}

}  // namespace manifuzz::test
