#include "oracle/bullet/ledger/deviations.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

#include "judging/faults/differences.hpp"

// Bullet 3, in world directions seen from A's position.

namespace manifuzz::ledger_of {
namespace {

/// GJK_MIN_DISTANCE of btGjkEpa2.cpp, in float.
constexpr double kGjkMinDistance = 1e-4;
/// gGjkEpaPenetrationTolerance of btGjkPairDetector.cpp, in float.
constexpr double kPenetrationTolerance = 1e-3;
/// By which btMinkowskiPenetrationDepthSolver moves them farther apart than they overlap.
constexpr double kExtraSeparation = 0.5;

/// In the plane, those of the corners and the middles of the icosahedron's edges that
/// getPenetrationDirections has: x and y of each, and of each its opposite.
constexpr double kUpright[][2] = {{0.951058, 0.309013},
                                  {0.951058, -0.309013},
                                  {0.587786, -0.809017},
                                  {0.000000, -1.000000},
                                  {-0.587786, -0.809017}};
/// The others.
constexpr double kSlanting[][2] = {
    {0.723608, -0.525725}, {-0.276388, -0.850649}, {-0.894426, 0},         {-0.276388, 0.850649},
    {0.723608, 0.525725},  {0.425323, -0.309011},  {-0.162456, -0.499995}, {0.262869, -0.809012},
    {0.425323, 0.309011},  {0.850648, 0},          {-0.525730, 0},         {-0.688190, -0.499997},
    {-0.162456, 0.499995}, {-0.688190, 0.499997},  {0.262869, 0.809012}};

std::vector<Vector2<double>> with_opposites(std::span<const double[2]> some) {
  std::vector<Vector2<double>> all;
  for (const auto& [x, y] : some) {
    all.emplace_back(x, y);
    all.emplace_back(-x, -y);
  }
  return all;
}

/// btVoronoiSimplexSolver takes corners for one that are nearer than the root of
/// VORONOI_DEFAULT_EQUAL_VERTEX_THRESHOLD.
constexpr double kEqualVertices = 1e-2;

/// The least and the most that the solver's second query may find between the displaced shapes.
struct Distances {
  double least = 0;
  double most = 0;
};

using FindDistances = Distances (*)(const Difference& difference, const Vector2<double>& place);

Distances exact_distance(const Difference& difference, const Vector2<double>& place) {
  const double distance = difference.distance_from(place);
  return {distance, distance};
}

/// Too far, where the nearest corner has another one so near that either is taken for both.
Distances distance_of_equal_vertices(const Difference& difference, const Vector2<double>& place) {
  const double distance = difference.distance_from(place);
  const auto& corners = difference.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if ((difference.after(i) - corners[i]).norm() > kEqualVertices) continue;
    const double to_both = distance_to_segment(place, corners[i], difference.after(i));
    if (to_both <= distance + kEqualVertices) return {distance, distance + kEqualVertices};
  }
  return {distance, distance};
}

/// Whether the solver makes this translation of B, or none, of one direction, from B to A and not
/// quite unit.
bool is_made_of(const Vector2<double>& towards_a, double overlap, const Deviation& d,
                const Difference& difference, FindDistances find_distances) {
  const PairCase& pair = d.right.pair();
  const double radii = is_round(pair) ? total_radius(pair) : 0;
  const double bound = 4 * d.right.bounds.separation;
  // A moves, and B's closest point to it is compared with where A was.
  const double moved = overlap + kExtraSeparation + radii;
  const Distances found = find_distances(difference, Vector2<double>(-moved * towards_a));
  if (d.got.count == 0) return overlap < bound || found.least <= bound;
  const Vector2<double> got = translation_of(d);
  const Vector2<double> normal = -towards_a.normalized();
  if (got.norm() > bound &&
      (got.normalized() - normal).norm() > bound / got.norm() + d.right.bounds.normal) {
    return false;
  }
  const auto depth_at = [&](double distance) {
    return std::abs(moved - (distance - radii)) * towards_a.norm();
  };
  const double at_least = depth_at(found.least);
  const double at_most = depth_at(found.most);
  return got.norm() >= std::min(at_least, at_most) - bound &&
         got.norm() <= std::max(at_least, at_most) + bound;
}

/// Whether the answer is what the solver makes of the direction in which they overlap least of
/// these.
bool is_of_least(const Deviation& d, const std::vector<Vector2<double>>& directions,
                 FindDistances find_distances) {
  if (is_of_points(d.kind)) return false;
  const Difference difference(d.right.pair());
  const double bound = 4 * d.right.bounds.separation;
  const auto overlap = [&](const Vector2<double>& n) {
    return difference.reach(Vector2<double>(-n));
  };
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2<double>& n : directions) least = std::min(least, overlap(n));
  return std::ranges::any_of(directions, [&](const Vector2<double>& n) {
    return overlap(n) <= least + bound && is_made_of(n, overlap(n), d, difference, find_distances);
  });
}

/// The solver's directions in the plane, and of flat shapes the others flattened.
std::vector<Vector2<double>> directions_of(BulletAsked asked) {
  std::vector<Vector2<double>> all = with_opposites(kUpright);
  if (asked == BulletAsked::flat) {
    std::ranges::copy(with_opposites(kSlanting), std::back_inserter(all));
  }
  return all;
}

}  // namespace

Declaration declaration_of_epa() {
  return {.frame = RoundingFrame::world,
          .min_vertices = 1,
          .takes_round = true,
          .claims = Claims::point,
          .clips = false,
          .points = PointsAt::surface_b,
          .tolerance = {.absolute = 1e-4}};  // EPA_ACCURACY
}

bool below_gjk_distance(const Deviation& d) {
  const double bound = 4 * d.right.bounds.separation;
  if (is_of_points(d.kind) || bound > kGjkMinDistance) return false;
  const double most = kGjkMinDistance + bound;
  const double least = least_depth(d);
  if (d.got.count == 0 && least < 0) return false;
  return std::abs(least) <= most && std::abs(deepest(d.got)) <= most;
}

bool gap_as_depth(const Deviation& d) {
  if (d.got.count == 0 || is_of_points(d.kind)) return false;
  const double gap = -least_depth(d);
  const double bound = 4 * d.right.bounds.separation;
  return bound <= kPenetrationTolerance && gap > 0 && gap <= kPenetrationTolerance &&
         std::abs(deepest(d.got)) <= gap + bound;
}

bool is_of_least_direction(const Deviation& d, BulletAsked asked) {
  return is_of_least(d, directions_of(asked), exact_distance);
}

bool is_of_least_direction_of_equal_vertices(const Deviation& d, BulletAsked asked) {
  return is_of_least(d, directions_of(asked), distance_of_equal_vertices);
}

bool direction_of_short_translation(const Deviation& d) {
  return is_translation_right(d, 4 * d.right.bounds.separation);
}

}  // namespace manifuzz::ledger_of
