#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "judging/ledger/differences.hpp"
#include "judging/ledger/gjk_deviations.hpp"

// Bullet 3, in world directions seen from A's position.

namespace manifuzz {
namespace {

/// GJK_MIN_DISTANCE of btGjkEpa2.cpp, in float.
constexpr double kGjkMinDistance = 1e-4;
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

/// What the solver makes of one direction, from B to A and not quite unit.
struct Displaced {
  bool touches = false;
  Vector2<double> translation{0, 0};  ///< of B
};

Displaced displaced_along(const ledger_of::Difference& difference, const Vector2<double>& towards_a,
                          double overlap, double radii) {
  // A moves, and B's closest point to it is compared with where A was.
  const double moved = overlap + kExtraSeparation + radii;
  const double distance = difference.distance_from(Vector2<double>(-moved * towards_a));
  if (distance == 0) return {};
  const double corrected = moved - (distance - radii);
  return {true, -corrected * towards_a};
}

/// Whether the answer is what the solver makes of the direction in which they overlap least of
/// these.
bool is_of_least(const Deviation& d, const std::vector<Vector2<double>>& directions) {
  const PairCase& pair = d.right.pair();
  const ledger_of::Difference difference(pair);
  const double bound = 4 * d.right.bounds.separation;
  const double radii = is_round(pair) ? total_radius(pair) : 0;
  const auto overlap = [&](const Vector2<double>& n) {
    return difference.reach(Vector2<double>(-n));
  };
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2<double>& n : directions) least = std::min(least, overlap(n));
  return std::ranges::any_of(directions, [&](const Vector2<double>& n) {
    if (overlap(n) > least + bound) return false;
    const Displaced made = displaced_along(difference, n, overlap(n), radii);
    const bool may_be_none = !made.touches || least < bound;
    if (d.got.count == 0) return may_be_none;
    return made.touches && (ledger_of::translation_of(d) - made.translation).norm() <= bound &&
           std::abs(ledger_of::translation_of(d).norm() - made.translation.norm()) <= bound;
  });
}

}  // namespace

bool gap_below_gjk_distance(const Deviation& d) {
  if (d.got.count == 0) return false;
  const double gap = -ledger_of::least_depth(d);
  const double bound = 4 * d.right.bounds.separation;
  return gap > 0 && gap <= kGjkMinDistance + bound && ledger_of::deepest(d.got) <= gap + bound;
}

bool least_of_fixed_directions(const Deviation& d) {
  return is_of_least(d, with_opposites(kUpright));
}

bool least_of_flattened_directions(const Deviation& d) {
  std::vector<Vector2<double>> all = with_opposites(kUpright);
  std::ranges::copy(with_opposites(kSlanting), std::back_inserter(all));
  return is_of_least(d, all);
}

}  // namespace manifuzz
