#pragma once

#include <algorithm>
#include <numeric>

#include "judging/unjudged.hpp"
#include "oracle/parry/ledger/engines.hpp"

// parry2d on polygons, segments and capsules against them: GJK, EPA and the clip of features.
//
// A fault repeats all that parry does with the case, in its order and its scalar, requires that
// this gives the answer, and sees where it left: then holds what it allows against the truth, or
// mends it.

namespace manifuzz::parry {

template <class Real>
std::vector<std::size_t> faces_of(const Shape<Real>& shape) {
  std::vector<std::size_t> faces(std::max<std::size_t>(shape.normals.size(), 1));
  std::iota(faces.begin(), faces.end(), std::size_t{0});
  return faces;
}

/// Whether a replay has no contact, of shapes that touch to the bound.
template <class Engine>
bool is_touch_left_out(const Deviation& d, const ReplayOf<Engine>& replay) {
  return Engine::answer(replay, d.right.pair()).count == 0 &&
         ledger_of::least_depth(d) <= d.right.bounds.separation;
}

/// Whether cosines tell these faces as near to the direction as those that were clipped.
template <class Real>
bool are_as_near(const Replay<Real>& replay, const std::array<std::size_t, 2>& faces) {
  const auto is_as_near = [](const Shape<Real>& shape, const Vector2<Real>& direction,
                             std::size_t face, std::size_t clipped) {
    return face == clipped ||
           shape.normals[face].dot(direction) >= shape.normals[clipped].dot(direction);
  };
  return is_as_near(replay.a.shape, replay.normal, faces[0], replay.faces[0]) &&
         is_as_near(replay.b.shape, normal_of_b(replay), faces[1], replay.faces[1]);
}

/// Whether the answer would be right with another pair of faces clipped along the same direction.
template <class Engine>
bool is_right_with_other_faces(const Deviation& d, ReplayOf<Engine> replay) {
  for (const std::size_t of_a : faces_of(replay.a.shape)) {
    for (const std::size_t of_b : faces_of(replay.b.shape)) {
      if (std::array{of_a, of_b} == replay.faces) continue;
      replay.points = clipped_by(replay, {of_a, of_b});
      if (is_right<Engine>(d, replay)) return true;
      // Where faces have no place in common parry gives the places of its search.
      const bool is_place_of_search = !replay.is_clipped && !replay.points.empty();
      if (is_place_of_search && are_as_near(replay, {of_a, of_b}) &&
          is_touch_left_out<Engine>(d, replay)) {
        return true;
      }
    }
  }
  return false;
}

/// The directions of both shapes' faces, in a's frame.
template <class Real>
std::vector<Vector2<Real>> directions_of(const Replay<Real>& replay) {
  std::vector<Vector2<Real>> all = replay.a.shape.normals;
  for (const Vector2<Real>& normal : replay.b.shape.normals) {
    all.push_back(-rotate<Real>(replay.between.rotation, normal));
  }
  return all;
}

/// Whether EPA ended within its tolerance between the directions of two faces, and the answer would
/// be right along that of the least deep face, with the faces clipped that touch there.
template <class Engine>
bool is_right_along_face(const Deviation& d, const ReplayOf<Engine>& replay) {
  const double tolerance = 100 * kEpsilonOf<Engine> + bound_of(d);
  if (replay.epa.end != EpaEnd::converged || excess_of<Engine>(d, replay) > tolerance) {
    return false;
  }
  return std::ranges::any_of(directions_of(replay), [&](const auto& direction) {
    auto mended = replay;
    mended.normal = direction;
    if (excess_of<Engine>(d, mended) > bound_of(d)) return false;
    mended.points = clipped_by(mended, mended.faces);
    return is_right<Engine>(d, mended) || is_right_with_other_faces<Engine>(d, mended);
  });
}

/// The farthest a - b of both shapes.
inline double reach_of_difference(const Deviation& d) {
  const ledger_of::Difference difference(d.right.pair());
  double most = 0;
  for (const Vector2<double>& corner : difference.corners()) most = std::max(most, corner.norm());
  return most + total_radius(d.right.pair());
}

inline bool is_refusal(GjkEnd end) {
  return end == GjkEnd::refused_apart || end == GjkEnd::refused_touching ||
         end == GjkEnd::refused_inside || end == GjkEnd::stalled_inside;
}

/// The case's shapes, or those that the answer says it used.
inline exact::StoredPair pair_of(const LostAnswer& lost) {
  const UsedShapes* const used = used_by(lost.answer);
  return used != nullptr ? exact::stored(lost.pair, *used) : exact::stored(lost.pair);
}

/// With other faces clipped the direction would be right, or that of the face from which EPA
/// is off by its tolerance: the nearest by cosine was taken.
template <class Engine>
bool clip_of_face_by_cosine(const Deviation& d) {
  const auto replay = replay_by<Engine>(d, kSearches);
  return replay && replay->route == Route::features && !replay->normal.isZero(0) &&
         (is_right_with_other_faces<Engine>(d, *replay) || is_right_along_face<Engine>(d, *replay));
}

/// Corners were dropped, and the faces that are left have the normals that they had before: with
/// their own the answer would be right.
template <class Engine>
bool normals_before_simplifying(const Deviation& d) {
  if (d.asked == nullptr) return false;
  const exact::StoredPair asked = exact::stored(*d.asked);
  const auto full = Engine::replays(asked);
  const auto kept = Engine::replays_of_simplified(asked);
  const auto own = Engine::replays(d.right.truth->stored());
  const auto corners = [](const auto& replay) {
    return replay.a.shape.corners.size() + replay.b.shape.corners.size();
  };
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (corners(kept[i]) == corners(full[i])) continue;
    if (!is_same_answer(d, Engine::answer(kept[i], *d.asked))) continue;
    if (is_right<Engine>(d, own[i]) || is_touch_left_out<Engine>(d, own[i])) return true;
  }
  return false;
}

/// EPA's faces have no normal: the square of a length is beyond the scalar's range.
template <class Engine>
bool squared_length_of_epa(const Deviation& d) {
  const auto replay = replay_by<Engine>(d, kSearches);
  return replay && replay->epa.is_out_of_range && replay->normal.isZero(0);
}

/// One of the clipped edges is along the normal, to a bound, and one of its ends alone would be
/// right: another place on it was taken. Or the place taken on an edge is beside its end, to the
/// bound, and with the end it would be right: the edge is so nearly along the normal.
template <class Engine>
bool edge_along_normal(const Deviation& d) {
  auto replay = replay_by<Engine>(d, kSearches);
  if (!replay || replay->route != Route::features || replay->normal.isZero(0)) return false;
  for (const Side side : {Side::a, Side::b}) {
    for (const std::size_t end : {0U, 1U}) {
      auto mended = *replay;
      mended.points = clipped_at(*replay, side, end, bound_of(d));
      if (is_right<Engine>(d, mended)) return true;
    }
  }
  return false;
}

/// EPA of a simplex of one corner: a normal that is outside of a corner's cone. A round corner's is
/// a single direction.
template <class Engine>
bool normal_of_corner_cones(const Deviation& d) {
  const auto replay = replay_by<Engine>(d, kSearches);
  if (!replay || replay->epa.end != EpaEnd::corner) return false;
  const double apart = shapes_apart(d, *replay);
  // Within both cones, no other corner is farther along it: D would be the radii.
  const CurveBounds bounds =
      curve_bounds(d.right.pair(), Engine::declaration(), d.right.truth->extent());
  if (excess_of<Engine>(d, *replay) - apart > bounds.minimality) return true;
  // Where a corner is round its cone is a single direction.
  return replay->route == Route::supports && d.kind == Kind::normal && is_round(d.right.pair()) &&
         std::abs(apart) <= 10 * kEpsilonOf<Engine> + bound_of(d);
}

/// No contact: EPA's first faces, or a new one, have the origin outside, and it gives None.
template <class Engine>
bool contact_lost_by_epa(const Deviation& d) {
  const auto replay = as_reported<Engine>(d);
  if (!replay || replay->epa.end != EpaEnd::lost) return false;
  // A circle's centre is then taken for a place on the other's surface.
  return replay->route == Route::ball || (d.got.count == 0 && (replay->route == Route::features ||
                                                               replay->route == Route::supports));
}

/// GJK went back from a step that does not lessen the distance as floats have it: the place before
/// it is off by the root of what they tell. With the step the answer is right, or short of that by
/// no more than GJK's tolerance.
template <class Engine>
bool step_back_of_gjk(const Deviation& d) {
  const auto replay = as_reported<Engine>(d);
  if (!replay) return false;
  const auto mended = replayed_after_step(*replay);
  if (!mended) return false;
  // The step may leave as much as GJK's other end does.
  const double share = relative_of<Engine>();
  return is_right<Engine>(d, *mended) ||
         excess_of<Engine>(d, *mended) <= share / (1 - share) * cores_apart(d) + bound_of(d);
}

/// GJK stopped within its relative tolerance of the distance.
template <class Engine>
bool stop_of_gjk(const Deviation& d) {
  const auto replay = replay_by<Engine>(d, kSearches);
  if (!replay || replay->gjk.end != GjkEnd::near_enough) return false;
  const double apart = shapes_apart(d, *replay);
  // D along it is the radii less min_bound, and max_bound is no less than the distance.
  const double share = relative_of<Engine>();
  return apart > 0 && excess_of<Engine>(d, *replay) <= share / (1 - share) * apart + bound_of(d);
}

/// GJK took for touching what is within its relative tolerance of the farthest support point.
template <class Engine>
bool touching_of_gjk(const Deviation& d) {
  const auto replay = as_reported<Engine>(d);
  if (!replay || (replay->gjk.end != GjkEnd::stalled_touching &&
                  replay->gjk.end != GjkEnd::refused_touching)) {
    return false;
  }
  // Corners that it refused on the way have nothing to do with it where it ends so without, too.
  if (replay->gjk.is_refused &&
      (replay->route == Route::ball || replay->gjk.end != GjkEnd::stalled_touching ||
       searched_without_refusals(*replay).gjk.end != GjkEnd::stalled_touching)) {
    return false;
  }
  const double apart =
      replay->route == Route::ball ? centre_from_surface(d) : shapes_apart(d, *replay);
  return std::abs(apart) <= relative_of<Engine>() * reach_of_difference(d) + bound_of(d);
}

/// No contact of shapes that overlap by no more than GJK's tolerance: a corner as near to the
/// origin as that is taken for one at the origin, and how far it lies before it for a gap.
template <class Engine>
bool is_gap_of_corner(const Deviation& d) {
  const auto replay = as_reported<Engine>(d);
  const double tolerance = 10 * kEpsilonOf<Engine> + bound_of(d);
  return replay && d.got.count == 0 && replay->gjk.end == GjkEnd::on_simplex &&
         replay->epa.end == EpaEnd::corner && std::abs(shapes_apart(d, *replay)) <= tolerance;
}

/// EPA gives the first new face that is nearer than the one it came from: the origin was within
/// GJK's tolerance of the simplex, or, if it had gone on, it would have ended within its own. Or
/// the simplex is a chord, of whose sides it takes the farther one for the nearer, and with the
/// signs of both mended the answer is right.
template <class Engine>
bool origin_within_tolerance(const Deviation& d) {
  if (d.kind == Kind::missed_contact && is_gap_of_corner<Engine>(d)) return true;
  const auto replay = replay_by<Engine>(d, kSearches);
  if (!replay) return false;
  const bool is_of_round = d.kind == Kind::normal && is_round(d.right.pair());
  if (replay->gjk.end == GjkEnd::on_simplex && replay->epa.end == EpaEnd::corner &&
      (d.kind == Kind::phantom_contact || is_of_round)) {
    // A corner as near as this is taken for one at the origin, and a direction in both corners'
    // cones for the one between them.
    return std::abs(shapes_apart(d, *replay)) <= 10 * kEpsilonOf<Engine> + bound_of(d);
  }
  if (replay->gjk.end == GjkEnd::on_simplex && replay->epa.end == EpaEnd::converged) {
    const auto mended = replayed_with_signs(*replay);
    return mended && is_right<Engine>(d, *mended);
  }
  if (replay->epa.end != EpaEnd::backward) return false;
  const double excess = excess_along<Engine>(d, *replay, replay->epa_going_on.normal);
  if (excess <= 100 * kEpsilonOf<Engine> + bound_of(d)) return true;
  const double tolerance = 10 * kEpsilonOf<Engine> * std::max(1.0, reach_of_difference(d));
  return std::abs(shapes_apart(d, *replay)) <= tolerance + bound_of(d);
}

/// GJK's simplex refused a corner that is not where another is, and the search ended.
template <class Engine>
bool equal_corners_of_gjk(const Deviation& d) {
  const auto replay = as_reported<Engine>(d);
  if (!replay || !replay->gjk.is_refused) return false;
  if (is_refusal(replay->gjk.end)) return true;
  // It ended within its tolerance, having turned away from corners that it would go on from.
  if (replay->route == Route::ball || replay->gjk.end != GjkEnd::stalled_touching) return false;
  const auto mended = searched_without_refusals(*replay);
  return mended.gjk.end != GjkEnd::stalled_touching &&
         excess_of<Engine>(d, mended) <= 100 * kEpsilonOf<Engine> + bound_of(d);
}

/// An answer that holds no number: the clip divides by an edge's run along the tangent, whose
/// reciprocal is infinite.
template <class Engine>
bool not_a_number_of_clip(const LostAnswer& lost) {
  if (lost.how != Lost::How::malformed) return false;
  const auto is_beyond_range = [](auto run) { return run != 0 && !std::isfinite(1 / run); };
  return std::ranges::any_of(Engine::replays(pair_of(lost)), [&](const auto& replay) {
    return (replay.is_clipped || !replay.both_ends.empty()) &&
           std::ranges::any_of(clipped_runs(replay), is_beyond_range) &&
           why_malformed(lost.pair, Engine::answer(replay, lost.pair)).has_value();
  });
}

}  // namespace manifuzz::parry
