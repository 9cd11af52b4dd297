#pragma once

#include <algorithm>

#include "oracle/parry/ledger/ball.hpp"
#include "oracle/parry/ledger/engines.hpp"

// parry2d on circles against any shape, on two capsules, and on cores that are apart.

namespace manifuzz::parry {

/// By how much EPA's direction misses the least depth. A circle's normal is another one: it is
/// taken from the place that EPA gives to the centre, however near that is.
template <class Engine>
double excess_of_epa(const Deviation& d, const ReplayOf<Engine>& replay) {
  const double of_answer = excess_of<Engine>(d, replay);
  if (replay.route != Route::ball) return of_answer;
  Vector2<typename Engine::Real> normal = replay.epa.normal;
  if (replay.a.shape.is_ball()) normal = -rotate(replay.between.rotation, normal);
  return std::min(of_answer, excess_along<Engine>(d, replay, normal));
}

inline bool has_polygon(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  return std::max(pair.a.polygon.count, pair.b.polygon.count) >= kMinVertices;
}

/// Whether GJK ended within its tolerance, or would but for the roundings of a place on a chord.
template <class Real>
bool is_stopped_by_tolerance(const Replay<Real>& replay) {
  return replay.gjk.end == GjkEnd::near_enough ||
         (replay.gjk.foot && !replay.gjk.is_refused &&
          replayed_with_unrounded_feet(replay).gjk.end == GjkEnd::near_enough);
}

/// How far closest_points_segment_segment may be from the nearest places of two cores.
template <class Engine>
double error_of_places(const Deviation& d) {
  const exact::RoughPair placed = exact::place_roughly(d.right.pair());
  const Vector2<double> along_a = placed.a.vertices[1] - placed.a.vertices[0];
  const Vector2<double> along_b = placed.b.vertices[1] - placed.b.vertices[0];
  // a <= _eps: the first end of a core that is so short, which is no farther off than it is long.
  const auto is_short = [](double length) { return length * length <= kEpsilonOf<Engine>; };
  const double by_short = (is_short(along_a.norm()) ? along_a.norm() : 0) +
                          (is_short(along_b.norm()) ? along_b.norm() : 0);
  if (by_short > 0) return by_short + bound_of(d);
  // denom > _eps, a length's fourth power: the first end of cores that are nearly parallel, or
  // short.
  const double sine = cross(along_a, along_b) / (along_a.norm() * along_b.norm());
  const double across = cross(along_a, along_b);
  const bool is_taken_for_parallel = across * across <= kEpsilonOf<Engine>;
  const double longest = std::max({along_a.norm(), along_b.norm(), cores_apart(d)});
  // The direction is across the one core, and the right one across the other.
  const double turn =
      (along_a.normalized() - std::copysign(1, along_a.dot(along_b)) * along_b.normalized()).norm();
  const double by_first_end = is_taken_for_parallel ? turn * longest + bound_of(d) : 0;
  // b f - c e loses as much as the denominator is smaller than its terms.
  return std::max(by_first_end, bound_of(d) / (sine * sine));
}

/// Whether GJK's direction is that of its step, between cores that it knows to be apart.
inline bool is_between_places(GjkEnd end) {
  return end == GjkEnd::stalled_apart || end == GjkEnd::refused_apart ||
         end == GjkEnd::full_apart || end == GjkEnd::near_enough;
}

/// Whether EPA's direction is right to its tolerance.
template <class Engine>
bool is_direction_of_epa_right(const Deviation& d, const ReplayOf<Engine>& replay) {
  return excess_of_epa<Engine>(d, replay) <= 100 * kEpsilonOf<Engine> + bound_of(d);
}

/// Whether a contact is dropped since the origin is on the chord that EPA ended on: its places are
/// apart by roundings.
template <class Engine>
bool is_dropped_on_chord(const Deviation& d, const ReplayOf<Engine>& replay) {
  return replay.route == Route::supports && replay.epa.end == EpaEnd::converged &&
         !replay.points.empty() && static_cast<double>(replay.points[0].distance) <= bound_of(d) &&
         is_direction_of_epa_right<Engine>(d, replay);
}

/// The normal is the direction between places on cores that are apart: off by their roundings over
/// the distance. The depth is right.
template <class Engine>
bool direction_of_parry_places(const Deviation& d) {
  const auto replay = as_reported<Engine>(d);
  const double apart = cores_apart(d);
  if (!replay || d.got.count == 0 || ledger_of::is_of_points(d.kind)) return false;
  const bool is_of_search = replay->route == Route::features && is_between_places(replay->gjk.end);
  // Roundings of its places make a gap of cores that touch.
  const bool is_made_apart =
      is_of_search && !replay->gjk.is_refused && std::abs(apart) <= bound_of(d);
  return (is_of_search || replay->route == Route::capsules) && (apart > 0 || is_made_apart) &&
         is_depth_right(d) &&
         error_of_direction<Engine>(d, *replay) * std::abs(apart) <= bound_of(d);
}

/// Two capsules: both ends of the clip would be right; one point is missing or another was taken.
template <class Engine>
bool second_point_of_parry_capsules(const Deviation& d) {
  auto replay = replay_by<Engine>(d, {Route::capsules});
  if (!replay || (d.kind != Kind::count && d.kind != Kind::extent)) return false;
  replay->points = replay->both_ends;
  return is_right<Engine>(d, *replay);
}

/// Two capsules whose cores overlap, or touch to rounding: their distance gives the normal, along
/// which points are placed.
template <class Engine>
bool crossing_of_parry_capsules(const Deviation& d) {
  const auto replay = replay_by<Engine>(d, {Route::capsules});
  const bool is_of_normal = !ledger_of::is_of_points(d.kind) || d.kind == Kind::witness;
  return replay && is_of_normal && cores_apart(d) <= bound_of(d);
}

/// Two capsules whose nearest places are off by roundings over the square of the sine between both.
template <class Engine>
bool nearly_parallel_parry_capsules(const Deviation& d) {
  const auto replay = replay_by<Engine>(d, {Route::capsules});
  const double apart = cores_apart(d);
  if (!replay || ledger_of::is_of_points(d.kind) || apart <= 0) return false;
  const double off = error_of_places<Engine>(d);
  if (static_cast<double>(length_of(replay->apart)) - apart > off) return false;
  return d.got.count == 0 || error_of_direction<Engine>(d, *replay) * apart <= off;
}

/// A circle whose centre EPA projects on the end of a chord instead of its nearest place.
template <class Engine>
bool corner_of_epa_chord(const Deviation& d) {
  const auto replay = as_reported<Engine>(d);
  return replay && replay->route != Route::features && replay->epa.is_of_chord;
}

/// A circle whose centre is on the other's surface, or core: the normal is a direction of
/// roundings, or that from the other's origin.
template <class Engine>
bool centre_on_surface(const Deviation& d) {
  const auto replay = replay_by<Engine>(d, {Route::ball});
  if (!replay || d.got.count == 0) return false;
  // Taken to be inside of a segment that is nearer than epsilon.
  const auto& other = replay->a.shape.is_ball() ? replay->b.shape : replay->a.shape;
  const bool is_of_segment = !other.is_polygon() && !other.is_capsule();
  if (is_of_segment && replay->is_inside && is_right<Engine>(d, replayed_beside_segment(*replay))) {
    return true;
  }
  // Taken to be on a core that is nearer than epsilon: the depth is off by no more than that.
  if (replay->is_on_core && std::abs(ledger_of::deepest(d.got) - ledger_of::least_depth(d)) <=
                                kEpsilonOf<Engine> + bound_of(d)) {
    return true;
  }
  const double surface = std::abs(centre_from_surface(d));
  // What GJK leaves of the distance outweighs roundings then.
  const bool is_of_stop = has_polygon(d) && replay->gjk.end == GjkEnd::near_enough;
  if (is_of_stop && relative_of<Engine>() * surface > bound_of(d)) return false;
  if (has_polygon(d) && replay->gjk.end == GjkEnd::on_simplex) {
    return surface <= 10 * kEpsilonOf<Engine> + bound_of(d);
  }
  const double error = error_of_direction<Engine>(d, *replay);
  // A capsule's surface is found from its core, a polygon's from a corner.
  const double nearest = has_polygon(d) ? surface : std::min(surface, cores_apart(d));
  return is_depth_right(d) && error * nearest <= bound_of(d);
}

/// A circle whose centre GJK projects on a polygon within its relative tolerance.
template <class Engine>
bool circle_by_gjk_stop(const Deviation& d) {
  const auto replay = replay_by<Engine>(d, {Route::ball});
  const double surface = centre_from_surface(d);
  if (!replay || surface <= 0 || !is_stopped_by_tolerance(*replay)) return false;
  // The place is in the shape, and no farther than the distance over 1 - _eps_rel.
  const double share = relative_of<Engine>() / (1 - relative_of<Engine>());
  const double found = static_cast<double>(length_of(replay->apart));
  if (std::abs(found - surface) > share * surface + bound_of(d)) return false;
  return d.got.count == 0 || error_of_direction<Engine>(d, *replay) <=
                                 std::sqrt(2 * share) * (1 + share) + bound_of(d) / surface;
}

/// EPA ends on a chord that is inside of the surface: the depth is too small, and the places are
/// not on it. Of contact manifolds, a circle's centre and a rounded polygon alone.
template <class Engine>
bool chord_of_epa(const Deviation& d) {
  const auto replay = as_reported<Engine>(d);
  if (!replay || replay->route == Route::features) return false;
  if (d.got.count == 0) return is_dropped_on_chord<Engine>(d, *replay);
  const bool is_exhausted = replay->epa.end == EpaEnd::exhausted;
  if (!is_exhausted && replay->epa.end != EpaEnd::converged &&
      replay->epa.end != EpaEnd::backward) {
    return false;
  }
  // The chord is inside of the surface, so the depth is too small; what supports its face is found
  // no farther than the tolerance.
  const double least = ledger_of::least_depth(d);
  return ledger_of::deepest(d.got) <= least + bound_of(d) &&
         (is_exhausted || is_direction_of_epa_right<Engine>(d, *replay));
}

/// GJK ended with a chord to which its direction leads back, without having converged: the origin's
/// place on it is rounded, and in a wider scalar the answer is right.
template <class Engine>
bool rounded_foot_of_gjk(const Deviation& d) {
  const auto replay = as_reported<Engine>(d);
  if (ledger_of::is_of_points(d.kind) || !replay || !replay->gjk.foot || replay->gjk.is_refused)
    return false;
  const auto& [foot, chord] = *replay->gjk.foot;
  const Vector2<double> from = chord[0].template cast<double>();
  const Vector2<double> to = chord[1].template cast<double>();
  // The share's error and those of its product and sum are each a few roundings of a coordinate.
  const Vector2<double> own = ledger_of::nearest_on_segment({0, 0}, from, to);
  const double roundings = 4 * kEpsilonOf<Engine> * std::max(from.norm(), to.norm());
  if (!((foot.template cast<double>() - own).norm() <= roundings)) return false;
  // Places on both shapes are rounded as the foot is: depth and direction may be off by as much.
  const auto error_of = [&](const auto& replayed) {
    const double apart = replayed.route == Route::ball ? centre_from_surface(d) : cores_apart(d);
    const double depth = ledger_of::deepest(Engine::answer(replayed, d.right.pair()));
    return std::max(std::abs(depth - ledger_of::least_depth(d)),
                    error_of_direction<Engine>(d, replayed) * std::abs(apart));
  };
  const auto mended = replayed_with_unrounded_feet(*replay);
  if (is_right<Engine>(d, mended)) return true;
  // A circle's centre that it would then find to be on the surface, within GJK's tolerance.
  if (mended.route == Route::ball && mended.gjk.end == GjkEnd::on_simplex) {
    return std::abs(centre_from_surface(d)) <= 10 * kEpsilonOf<Engine> + bound_of(d);
  }
  const double left = error_of(mended);
  return left <= bound_of(d) + roundings &&
         error_of(*replay) > std::max(left, d.right.bounds.separation);
}

}  // namespace manifuzz::parry
