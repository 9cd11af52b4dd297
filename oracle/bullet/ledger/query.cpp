#include "oracle/bullet/ledger/query.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/libccd/ledger/simplex.hpp"

namespace manifuzz::ledger_of {
namespace {

constexpr float kEpsilon = std::numeric_limits<float>::epsilon();
/// REL_ERROR2 of btGjkPairDetector.cpp.
constexpr float kRelativeError = 1e-6F;
/// gGjkEpaPenetrationTolerance.
constexpr float kCaught = 0.001F;

/// The difference's corner along -axis.
DifferenceCorner corner_towards(const BulletPair& pair, const Space& axis) {
  DifferenceCorner corner;
  corner.on_a = pair.place_a.to_world(pair.a.farthest(pair.place_a.to_local(Space(-axis))));
  corner.on_b = pair.place_b.to_world(pair.b.farthest(pair.place_b.to_local(axis)));
  corner.w = corner.on_a - corner.on_b;
  return corner;
}

/// How far apart they are along a normal from B to A.
float distance_along(const BulletPair& pair, const Space& normal) {
  return dot(normal, corner_towards(pair, normal).w) - (pair.a.margin + pair.b.margin);
}

/// Why a corner is not added to the simplex; none where it is.
QueryEnd end_before(const VoronoiSimplex& simplex, const QueryLoop& loop, const Space& w,
                    float square_max) {
  const float far = dot(loop.axis, w);
  if (far > 0 && far * far > loop.square * square_max) return QueryEnd::apart;
  if (simplex.holds(w)) return QueryEnd::equal_vertex;
  const float closer = loop.square - far;
  if (closer > loop.square * kRelativeError) return QueryEnd::none;
  return closer <= 0 ? QueryEnd::no_closer : QueryEnd::little_closer;
}

QueryLoop run_loop(const BulletPair& pair, float square_max) {
  constexpr int iterations_max = 1000;
  VoronoiSimplex simplex;
  QueryLoop loop;
  for (int i = 0; i <= iterations_max; ++i) {
    const DifferenceCorner corner = corner_towards(pair, loop.axis);
    loop.end = end_before(simplex, loop, corner.w, square_max);
    loop.is_by_threshold = loop.end == QueryEnd::equal_vertex && simplex.holds_another(corner.w);
    const float closer = loop.square - dot(loop.axis, corner.w);
    loop.is_closest_rounded = loop.end == QueryEnd::equal_vertex && !loop.is_by_threshold &&
                              closer > loop.square * kRelativeError;
    if (loop.end != QueryEnd::none) break;
    if (!simplex.add(corner)) {
      loop.end = QueryEnd::degenerate;
      break;
    }
    const float square = squared(simplex.closest().w);
    if (square < kRelativeError) {
      loop.axis = simplex.closest().w;
      loop.end = QueryEnd::at_origin;
      break;
    }
    const float before = loop.square;
    loop.square = square;
    if (before - square <= kEpsilon * before) {
      loop.end = QueryEnd::no_less;
      break;
    }
    loop.axis = simplex.closest().w;
    if (simplex.is_full()) {
      loop.end = QueryEnd::full;
      break;
    }
  }
  loop.closest = simplex.closest();
  return loop;
}

/// What its copy of libccd's GJK says of the cores: status is 0.
bool do_cores_intersect(const BulletPair& pair) {
  CcdSimplexOf<float> simplex;
  Space dir(0, 0, 0);
  return is_intersection([&](const Space& along) { return corner_towards(pair, Space(-along)).w; },
                         simplex, dir);
}

/// The closest points of the loop, on the margins.
void take_query(BulletAnswer& answer, const BulletPair& pair) {
  const QueryLoop& loop = answer.loop;
  const float square = squared(loop.axis);
  if (loop.end == QueryEnd::none || loop.end == QueryEnd::full) return;
  if (!(square > kEpsilon * kEpsilon)) return;
  const float reciprocal = 1.0F / std::sqrt(square);
  answer.normal_of = NormalOf::query;
  answer.normal = loop.axis * reciprocal;
  answer.on_b = loop.closest.on_b + loop.axis * (pair.b.margin / std::sqrt(loop.square));
  answer.distance = (1.0F / reciprocal) - (pair.a.margin + pair.b.margin);
}

/// What the solver says takes the query's place only where it is deeper.
void take_solver(BulletAnswer& answer, const SolverAnswer& found, const BulletPair& pair) {
  if (squared(found.axis) == 0) return;
  const bool is_none = answer.normal_of == NormalOf::nobody;
  const float between = std::sqrt(squared(Space(found.on_a - found.on_b)));
  if (!found.is_deep) {
    const float distance = between - (pair.a.margin + pair.b.margin);
    if (!is_none && !(distance < answer.distance)) return;
    answer.normal_of = NormalOf::solver_apart;
    answer.distance = distance;
    answer.on_b = found.on_b + found.axis * pair.b.margin;
    answer.normal = over(found.axis, std::sqrt(squared(found.axis)));
    return;
  }
  Space normal = found.on_b - found.on_a;
  if (squared(normal) <= kEpsilon * kEpsilon) normal = found.axis;
  if (!(squared(normal) > kEpsilon * kEpsilon)) return;
  if (!is_none && !(-between < answer.distance)) return;
  answer.normal_of = NormalOf::solver;
  answer.normal = over(normal, std::sqrt(squared(normal)));
  answer.distance = -between;
  answer.on_b = found.on_b;
}

/// What it does to "detect the issue and revert the normal".
void revert_normal(BulletAnswer& answer, const BulletPair& pair, const Space& of_query) {
  const float d2 = distance_along(pair, of_query);
  const float d1 = distance_along(pair, Space(-answer.normal));
  const float d0 = distance_along(pair, answer.normal);
  if (d1 > d0) {
    answer.is_turned = true;
    answer.normal *= -1;
  }
  if (squared(of_query) == 0 || !(d2 > d0 && d2 > d1 && d2 > answer.distance)) return;
  answer.is_axis_deeper = true;
  answer.normal = of_query;
  answer.distance = d2;
}

/// Halfway between both origins.
Space offset_of(const BulletPair& pair) {
  return (pair.place_a.origin + pair.place_b.origin) * 0.5F;
}

BulletPair moved_by(const Space& offset, BulletPair pair) {
  pair.place_a.origin -= offset;
  pair.place_b.origin -= offset;
  return pair;
}

template <class DoIntersect>
BulletAnswer answer_of(const BulletPair& given, DepthSolver solver, void* trace, float square_max,
                       const DoIntersect& do_intersect) {
  const Space offset = offset_of(given);
  const BulletPair pair = moved_by(offset, given);
  BulletAnswer answer;
  answer.loop = run_loop(pair, square_max);
  take_query(answer, pair);
  answer.cached_axis = answer.loop.axis;
  const Space of_query = answer.normal;
  const bool is_caught = answer.loop.end != QueryEnd::none &&
                         answer.distance + (pair.a.margin + pair.b.margin) < kCaught;
  if (solver != nullptr &&
      (answer.normal_of == NormalOf::nobody || is_caught || do_intersect(pair))) {
    answer.is_solver_asked = true;
    const SolverAnswer found = solver(pair, trace);
    answer.cached_axis = found.axis;
    take_solver(answer, found, pair);
  }
  if (answer.normal_of == NormalOf::nobody) return answer;
  if (!(answer.distance < 0 || answer.distance * answer.distance < square_max)) {
    answer.normal_of = NormalOf::nobody;
    return answer;
  }
  answer.cached_axis = answer.normal;
  revert_normal(answer, pair, of_query);
  answer.on_b += offset;
  return answer;
}

}  // namespace

BulletAnswer ask_detector(const BulletPair& pair, DepthSolver solver, void* trace,
                          float square_max) {
  return answer_of(pair, solver, trace, square_max, do_cores_intersect);
}

BulletAnswer ask_detector_told(bool do_intersect, const BulletPair& pair, DepthSolver solver,
                               void* trace, float square_max) {
  return answer_of(pair, solver, trace, square_max,
                   [do_intersect](const BulletPair&) { return do_intersect; });
}

bool is_intersection_of_memory(const BulletPair& given) {
  if (!given.is_flat) return false;
  const BulletPair pair = moved_by(offset_of(given), given);
  bool is_of_memory = false;
  CcdSimplexOf<float> simplex;
  Space dir(0, 0, 0);
  is_intersection(
      [&](const Space& along) {
        is_of_memory = is_of_memory || !pair.a.has_farthest(pair.place_a.to_local(along)) ||
                       !pair.b.has_farthest(pair.place_b.to_local(Space(-along)));
        return corner_towards(pair, Space(-along)).w;
      },
      simplex, dir);
  return is_of_memory;
}

}  // namespace manifuzz::ledger_of
