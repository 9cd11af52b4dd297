#pragma once

#include "oracle/bullet/ledger/voronoi_simplex.hpp"

namespace manifuzz::ledger_of {

/// Why the loop of btGjkPairDetector ends, as its m_degenerateSimplex says.
enum class QueryEnd {
  none = 0,
  equal_vertex = 1,    ///< inSimplex
  no_closer = 2,       ///< the corner is no farther along the axis
  degenerate = 3,      ///< the simplex has no closest point
  at_origin = 6,       ///< the closest point is nearer than 0.001, the root of REL_ERROR2
  apart = 10,          ///< by more than the caller asks for
  little_closer = 11,  ///< by less than REL_ERROR2 of the squared distance
  no_less = 12,        ///< the squared distance is hardly less than before
  full = 13,
};

/// One loop of btGjkPairDetector, without margins.
struct QueryLoop {
  QueryEnd end = QueryEnd::none;
  bool is_by_threshold = false;  ///< it ended at another corner than the simplex holds
  /// It ended at a corner of the simplex that is nearer than the closest point said to be of it.
  bool is_closest_rounded = false;
  Space axis{0, 1, 0};   ///< from B to A
  float square = 1e18F;  ///< of the distance
  DifferenceCorner closest{};
};

/// What a depth solver says: calcPenDepth.
struct SolverAnswer {
  bool is_deep = false;  ///< what it returns
  Space axis{0, 0, 0};
  Space on_a{0, 0, 0};
  Space on_b{0, 0, 0};
};

/// Whose normal btGjkPairDetector gives.
enum class NormalOf { nobody, query, solver, solver_apart };

/// The answer of btGjkPairDetector::getClosestPointsNonVirtual, and how it came.
struct BulletAnswer {
  NormalOf normal_of = NormalOf::nobody;
  Space normal{0, 0, 0};
  Space on_b{0, 0, 0};
  float distance = 0;
  QueryLoop loop;
  bool is_solver_asked = false;
  bool is_axis_deeper = false;  ///< the query's axis took the place of the solver's: d2 > d0
  bool is_turned = false;       ///< d1 > d0: the normal was reversed
  Space cached_axis{0, 0, 0};   ///< getCachedSeparatingAxis, after it
};

using DepthSolver = SolverAnswer (*)(const BulletPair& pair, void* trace);

/// Without a solver where that is null, which is given `trace`.
BulletAnswer ask_detector(const BulletPair& pair, DepthSolver solver, void* trace,
                          float square_max);

/// Whether the copy of libccd's GJK in it asks for the corner along a direction of which no product
/// is above the least float, as overflows make it: a flat btConvexHullShape then gives what is in
/// memory before its corners, and whether they intersect is not to be repeated.
bool is_intersection_of_memory(const BulletPair& pair);
/// The answer where that copy says so, whatever it is.
BulletAnswer ask_detector_told(bool do_intersect, const BulletPair& pair, DepthSolver solver,
                               void* trace, float square_max);

/// What btMinkowskiPenetrationDepthSolver did.
struct MinkowskiTrace {
  float overlap = 0;  ///< least of all directions'
  Space direction{0, 0, 0};
  float moved = 0;      ///< how far A is displaced along it; 0: it was not
  BulletAnswer beside;  ///< of the displaced query
};

/// btMinkowskiPenetrationDepthSolver::calcPenDepth; `trace` is a MinkowskiTrace.
SolverAnswer solve_by_directions(const BulletPair& pair, void* trace);

}  // namespace manifuzz::ledger_of
