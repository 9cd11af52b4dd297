#pragma once

#include "oracle/bullet/ledger/query.hpp"

namespace manifuzz::ledger_of {

/// How EPA::Evaluate of btGjkEpa2.cpp ends.
enum class BulletEpaEnd {
  none,
  invalid_hull,
  out_of_faces,
  out_of_vertices,
  accuracy_reached,
  fall_back
};

/// What btGjkEpaPenetrationDepthSolver did.
struct EpaTrace {
  BulletEpaEnd end = BulletEpaEnd::none;
  Space normal{0, 0, 0};  ///< outwards of the face it ends at
  float depth = 0;        ///< that face's d
  /// The origin's projection to the plane of that face is not in it: d is an edge's or a corner's
  /// distance (getedgedist), but what n * d makes of it is not on the face.
  bool is_beside_face = false;
  bool is_near = false;  ///< its GJK ended by GJK_MIN_DISTANCE
};

/// btGjkEpaPenetrationDepthSolver::calcPenDepth; `trace` is an EpaTrace.
SolverAnswer solve_by_epa(const BulletPair& pair, void* trace);

}  // namespace manifuzz::ledger_of
