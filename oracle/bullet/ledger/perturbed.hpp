#pragma once

#include <vector>

#include "judging/faults/replayed.hpp"
#include "oracle/bullet/ledger/epa.hpp"
#include "oracle/bullet/ledger/manifold.hpp"

namespace manifuzz::ledger_of {

/// What of btConvexConvexAlgorithm::processCollision is left out.
struct PerturbedParts {
  bool has_turned = true;    ///< the queries of turned shapes
  bool is_refreshed = true;  ///< refreshContactPoints at the end
  bool does_replace = true;  ///< a point takes the place of one nearby: getCacheEntry
};

/// The answer of btConvexConvexAlgorithm with btGjkEpaPenetrationDepthSolver, three turns and four
/// points enough; and how its first query came.
struct PerturbedAnswer {
  BulletAnswer first;
  EpaTrace epa;
  std::vector<BulletPoint> points;
};

PerturbedAnswer ask_perturbed(const BulletPair& pair, const PerturbedParts& parts);

/// What oracle/bullet makes of them in the plane: the deepest, and the one farthest from it.
replayed::Contact seen_in_plane(const std::vector<BulletPoint>& points);

}  // namespace manifuzz::ledger_of
