#pragma once

#include <cmath>

#include "judging/by_curve.hpp"
#include "judging/faults/differences.hpp"
#include "judging/unjudged.hpp"
#include "oracle/parry/ledger/replay.hpp"

// The colliders whose answers are replayed, and how an answer is held against a replay, whichever
// of them gave it.

namespace manifuzz::parry {

/// parry2d as its adapters ask it, in a scalar.
template <class Scalar>
struct AsAdapters {
  using Real = Scalar;
  /// What it does with a pair, in the one or two orders in which it may be asked.
  static std::vector<Replay<Real>> replays(const exact::StoredPair& pair);
  /// The replays of polygons made by from_convex_polyline.
  static std::vector<Replay<Real>> replays_of_simplified(const exact::StoredPair& pair);
  /// The direction that was found, in A's frame: unit, but for roundings.
  static Vector2<double> direction(const Replay<Real>& replay, const PairCase& pair);
  /// What is answered of a replay.
  static Manifold<double> answer(const Replay<Real>& replay, const PairCase& pair);
  static const Declaration& declaration();
};
using Floats = AsAdapters<float>;
using Doubles = AsAdapters<double>;

/// What the adapters declare of every collider that clips along a direction of its own.
inline Declaration declared(ScalarType scalar, double epsilon) {
  return {.scalar = scalar,
          .frame = RoundingFrame::world,
          .min_vertices = 1,
          .takes_round = true,
          .clips = false,
          .points = PointsAt::midpoint,
          .tolerance = {.absolute = 100 * epsilon}};
}

template <class Engine>
using ReplayOf = Replay<typename Engine::Real>;

template <class Engine>
inline constexpr double kEpsilonOf = static_cast<double>(kEpsilon<typename Engine::Real>);

/// _eps_rel of GJK.
template <class Engine>
double relative_of() {
  return std::sqrt(10 * kEpsilonOf<Engine>);
}

/// How far figures that are right to rounding may be off, as sums of a few of them.
inline double bound_of(const Deviation& d) {
  return 4 * d.right.bounds.separation;
}

/// How far the cores are apart; below zero they overlap.
inline double cores_apart(const Deviation& d) {
  return total_radius(d.right.pair()) - ledger_of::least_depth(d);
}

/// How far the shapes are apart that GJK was asked about: cores, or shapes with their radii.
template <class Real>
double shapes_apart(const Deviation& d, const Replay<Real>& replay) {
  return replay.route == Route::supports ? -ledger_of::least_depth(d) : cores_apart(d);
}

/// How far a circle's centre is from the other's surface; below zero it is inside.
inline double centre_from_surface(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const Body& circle = pair.a.polygon.count == 1 ? pair.a : pair.b;
  return static_cast<double>(circle.polygon.radius) - ledger_of::least_depth(d);
}

/// Whether the replay gives the answer, to a bound.
inline bool is_same_answer(const Deviation& d, const Manifold<double>& answer) {
  if (answer.count != d.got.count) return false;
  if (answer.count == 0) return true;
  const double bound = d.right.bounds.separation;
  if (!((answer.normal - d.got.normal).norm() <= d.right.bounds.normal)) return false;
  for (int i = 0; i < answer.count; ++i) {
    const ContactPoint<double>& made = answer.points[static_cast<std::size_t>(i)];
    const ContactPoint<double>& got = d.got.points[static_cast<std::size_t>(i)];
    if (!(std::abs(made.depth - got.depth) <= bound)) return false;
    if (!((made.position - got.position).norm() <= bound)) return false;
  }
  return true;
}

/// The replay of an answer; none where it gives another.
template <class Engine>
std::optional<ReplayOf<Engine>> as_reported(const Deviation& d) {
  for (ReplayOf<Engine>& replay : Engine::replays(d.right.truth->stored())) {
    if (is_same_answer(d, Engine::answer(replay, d.right.pair()))) return std::move(replay);
  }
  return std::nullopt;
}

/// What GJK and EPA search, of shapes without a ball.
inline constexpr std::initializer_list<Route> kSearches{Route::features, Route::supports};

/// The replay of an answer that was found by one of these routes.
template <class Engine>
std::optional<ReplayOf<Engine>> replay_by(const Deviation& d, std::initializer_list<Route> routes) {
  auto replay = as_reported<Engine>(d);
  if (replay && std::ranges::find(routes, replay->route) == routes.end()) replay.reset();
  return replay;
}

template <class Engine>
bool is_right(const Deviation& d, const ReplayOf<Engine>& mended) {
  const Manifold<double> answer = Engine::answer(mended, d.right.pair());
  if (answer.count == 0 && d.kind != Kind::phantom_contact) return false;
  if (why_malformed(d.right.pair(), answer)) return false;
  const PartialManifold partial{.manifold = answer, .has_midpoints = false};
  return judge_by_curve(*d.right.truth, Engine::declaration(), partial).kind == Kind::none;
}

/// D along the direction that was found, less D*; infinite where it found none.
template <class Engine>
double excess_of(const Deviation& d, const ReplayOf<Engine>& replay) {
  const Vector2<double> direction = Engine::direction(replay, d.right.pair());
  if (direction.isZero(0) || !direction.allFinite()) return INFINITY;
  return exact::Along(*d.right.truth, direction).depth() - ledger_of::least_depth(d);
}

/// The excess of depth along another direction, in a's frame.
template <class Engine>
double excess_along(const Deviation& d, const ReplayOf<Engine>& replay,
                    const Vector2<typename Engine::Real>& direction) {
  ReplayOf<Engine> turned = replay;
  turned.normal = direction;
  return excess_of<Engine>(d, turned);
}

/// How far that direction is from a right one; infinite where it found none.
template <class Engine>
double error_of_direction(const Deviation& d, const ReplayOf<Engine>& replay) {
  const exact::PenetrationCurve curve(*d.right.truth, exact::skin_of(*d.right.truth));
  const Vector2<double> direction = Engine::direction(replay, d.right.pair());
  double least = INFINITY;
  if (direction.isZero(0) || !direction.allFinite()) return least;
  for (const Vector2<double>& right : curve.minima(bound_of(d))) {
    least = std::min(least, (direction.normalized() - right).norm());
  }
  return least;
}

inline bool is_depth_right(const Deviation& d) {
  return std::abs(ledger_of::deepest(d.got) - ledger_of::least_depth(d)) <= bound_of(d);
}

}  // namespace manifuzz::parry
