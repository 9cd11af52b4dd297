#include <algorithm>
#include <numeric>

#include "oracle/parry/ledger/engines.hpp"

// parry2d on polygons, segments and capsules against them: GJK, EPA and the clip of features.

namespace manifuzz {
namespace {

using parry::bound_of;
using parry::cores_apart;
using parry::EpaEnd;
using parry::GjkEnd;
using parry::Route;

template <class Engine>
std::optional<parry::ReplayOf<Engine>> replay_of_search(const Deviation& d) {
  auto replay = parry::as_reported<Engine>(d);
  if (replay && replay->route != Route::features && replay->route != Route::supports) {
    replay.reset();
  }
  return replay;
}

template <class Real>
std::vector<std::size_t> faces_of(const parry::Shape<Real>& shape) {
  std::vector<std::size_t> faces(std::max<std::size_t>(shape.normals.size(), 1));
  std::iota(faces.begin(), faces.end(), std::size_t{0});
  return faces;
}

/// Whether the answer would be right with another pair of faces clipped along the same direction.
template <class Engine>
bool is_right_with_other_faces(const Deviation& d, parry::ReplayOf<Engine> replay) {
  for (const std::size_t of_a : faces_of(replay.a.shape)) {
    for (const std::size_t of_b : faces_of(replay.b.shape)) {
      if (std::array{of_a, of_b} == replay.faces) continue;
      replay.points = parry::clipped_by(replay, {of_a, of_b});
      if (parry::is_right<Engine>(d, replay)) return true;
    }
  }
  return false;
}

/// The directions of both shapes' faces, in a's frame.
template <class Real>
std::vector<Vector2<Real>> directions_of(const parry::Replay<Real>& replay) {
  std::vector<Vector2<Real>> all = replay.a.shape.normals;
  for (const Vector2<Real>& normal : replay.b.shape.normals) {
    all.push_back(-rotate<Real>(replay.between.rotation, normal));
  }
  return all;
}

/// Whether EPA ended within its tolerance between the directions of two faces, and the answer would
/// be right along that of the least deep face, with the faces clipped that touch there.
template <class Engine>
bool is_right_along_face(const Deviation& d, const parry::ReplayOf<Engine>& replay) {
  const double tolerance = 100 * parry::kEpsilonOf<Engine> + bound_of(d);
  if (replay.epa.end != EpaEnd::converged || parry::excess_of<Engine>(d, replay) > tolerance) {
    return false;
  }
  return std::ranges::any_of(directions_of(replay), [&](const auto& direction) {
    auto mended = replay;
    mended.normal = direction;
    if (parry::excess_of<Engine>(d, mended) > bound_of(d)) return false;
    mended.points = parry::clipped_by(mended, mended.faces);
    return parry::is_right<Engine>(d, mended) || is_right_with_other_faces<Engine>(d, mended);
  });
}

/// The farthest a - b of both shapes.
double reach_of_difference(const Deviation& d) {
  const ledger_of::Difference difference(d.right.pair());
  double most = 0;
  for (const Vector2<double>& corner : difference.corners()) most = std::max(most, corner.norm());
  return most + total_radius(d.right.pair());
}

/// Whether a replay has no contact, of shapes that touch to the bound.
template <class Engine>
bool is_touch_left_out(const Deviation& d, const parry::ReplayOf<Engine>& replay) {
  return Engine::answer(replay, d.right.pair()).count == 0 &&
         ledger_of::least_depth(d) <= d.right.bounds.separation;
}

bool is_refusal(GjkEnd end) {
  return end == GjkEnd::refused_apart || end == GjkEnd::refused_touching ||
         end == GjkEnd::refused_inside || end == GjkEnd::stalled_inside;
}

/// The case's shapes, or those that the answer says it used.
exact::StoredPair pair_of(const LostAnswer& lost) {
  const UsedShapes* const used = used_by(lost.answer);
  return used != nullptr ? exact::stored(lost.pair, *used) : exact::stored(lost.pair);
}

}  // namespace

template <class Engine>
bool clip_of_face_by_cosine(const Deviation& d) {
  const auto replay = replay_of_search<Engine>(d);
  return replay && replay->route == Route::features && !replay->normal.isZero(0) &&
         (is_right_with_other_faces<Engine>(d, *replay) || is_right_along_face<Engine>(d, *replay));
}

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
    if (!parry::is_same_answer(d, Engine::answer(kept[i], *d.asked))) continue;
    if (parry::is_right<Engine>(d, own[i]) || is_touch_left_out<Engine>(d, own[i])) return true;
  }
  return false;
}

template <class Engine>
bool squared_length_of_epa(const Deviation& d) {
  const auto replay = replay_of_search<Engine>(d);
  return replay && replay->epa.is_out_of_range && replay->normal.isZero(0);
}

template <class Engine>
bool edge_along_normal(const Deviation& d) {
  auto replay = replay_of_search<Engine>(d);
  if (!replay || replay->route != Route::features || replay->normal.isZero(0)) return false;
  for (const Side side : {Side::a, Side::b}) {
    for (const std::size_t end : {0U, 1U}) {
      auto mended = *replay;
      mended.points = parry::clipped_at(*replay, side, end, bound_of(d));
      if (parry::is_right<Engine>(d, mended)) return true;
    }
  }
  return false;
}

template <class Engine>
bool normal_of_corner_cones(const Deviation& d) {
  const auto replay = replay_of_search<Engine>(d);
  if (!replay || replay->epa.end != EpaEnd::corner) return false;
  const double apart = parry::shapes_apart(d, *replay);
  // Within both cones, no other corner is farther along it: D would be the radii.
  if (parry::excess_of<Engine>(d, *replay) - apart > bound_of(d)) return true;
  // Where a corner is round its cone is a single direction.
  return replay->route == Route::supports && d.kind == Kind::normal && is_round(d.right.pair()) &&
         std::abs(apart) <= 10 * parry::kEpsilonOf<Engine> + bound_of(d);
}

template <class Engine>
bool contact_lost_by_epa(const Deviation& d) {
  const auto replay = parry::as_reported<Engine>(d);
  if (!replay || replay->epa.end != EpaEnd::lost) return false;
  // A circle's centre is then taken for a place on the other's surface.
  return replay->route == Route::ball || (d.got.count == 0 && (replay->route == Route::features ||
                                                               replay->route == Route::supports));
}

template <class Engine>
bool step_back_of_gjk(const Deviation& d) {
  const auto replay = parry::as_reported<Engine>(d);
  if (!replay) return false;
  const auto mended = parry::replayed_after_step(*replay);
  if (!mended) return false;
  // The step may leave as much as GJK's other end does.
  const double share = parry::relative_of<Engine>();
  return parry::is_right<Engine>(d, *mended) ||
         parry::excess_of<Engine>(d, *mended) <= share / (1 - share) * cores_apart(d) + bound_of(d);
}

template <class Engine>
bool stop_of_gjk(const Deviation& d) {
  const auto replay = replay_of_search<Engine>(d);
  if (!replay || replay->gjk.end != GjkEnd::near_enough) return false;
  const double apart = parry::shapes_apart(d, *replay);
  // D along it is the radii less min_bound, and max_bound is no less than the distance.
  const double share = parry::relative_of<Engine>();
  return apart > 0 &&
         parry::excess_of<Engine>(d, *replay) <= share / (1 - share) * apart + bound_of(d);
}

template <class Engine>
bool touching_of_gjk(const Deviation& d) {
  const auto replay = parry::as_reported<Engine>(d);
  if (!replay || (replay->gjk.end != GjkEnd::stalled_touching &&
                  replay->gjk.end != GjkEnd::refused_touching)) {
    return false;
  }
  // Corners that it refused on the way have nothing to do with it where it ends so without, too.
  if (replay->gjk.is_refused &&
      (replay->route == Route::ball || replay->gjk.end != GjkEnd::stalled_touching ||
       parry::searched_without_refusals(*replay).gjk.end != GjkEnd::stalled_touching)) {
    return false;
  }
  const double apart = replay->route == Route::ball ? parry::centre_from_surface(d)
                                                    : parry::shapes_apart(d, *replay);
  return std::abs(apart) <= parry::relative_of<Engine>() * reach_of_difference(d) + bound_of(d);
}

template <class Engine>
bool origin_within_tolerance(const Deviation& d) {
  const auto replay = replay_of_search<Engine>(d);
  if (!replay) return false;
  if (replay->gjk.end == GjkEnd::on_simplex && replay->epa.end == EpaEnd::corner &&
      d.kind == Kind::phantom_contact) {
    // A corner as near as this is taken for one at the origin.
    return parry::shapes_apart(d, *replay) <= 10 * parry::kEpsilonOf<Engine> + bound_of(d);
  }
  if (replay->gjk.end == GjkEnd::on_simplex && replay->epa.end == EpaEnd::converged) {
    const auto mended = parry::replayed_with_signs(*replay);
    return mended && parry::is_right<Engine>(d, *mended);
  }
  if (replay->epa.end != EpaEnd::backward) return false;
  const double excess = parry::excess_along<Engine>(d, *replay, replay->epa_going_on.normal);
  if (excess <= 100 * parry::kEpsilonOf<Engine> + bound_of(d)) return true;
  const double tolerance = 10 * parry::kEpsilonOf<Engine> * std::max(1.0, reach_of_difference(d));
  return std::abs(parry::shapes_apart(d, *replay)) <= tolerance + bound_of(d);
}

template <class Engine>
bool equal_corners_of_gjk(const Deviation& d) {
  const auto replay = parry::as_reported<Engine>(d);
  if (!replay || !replay->gjk.is_refused) return false;
  if (is_refusal(replay->gjk.end)) return true;
  // It ended within its tolerance, having turned away from corners that it would go on from.
  if (replay->route == Route::ball || replay->gjk.end != GjkEnd::stalled_touching) return false;
  const auto mended = parry::searched_without_refusals(*replay);
  return mended.gjk.end != GjkEnd::stalled_touching &&
         parry::excess_of<Engine>(d, mended) <= 100 * parry::kEpsilonOf<Engine> + bound_of(d);
}

template <class Engine>
bool not_a_number_of_clip(const LostAnswer& lost) {
  if (lost.how != Lost::How::malformed) return false;
  const auto is_beyond_range = [](auto run) { return run != 0 && !std::isfinite(1 / run); };
  return std::ranges::any_of(Engine::replays(pair_of(lost)), [&](const auto& replay) {
    return (replay.is_clipped || !replay.both_ends.empty()) &&
           std::ranges::any_of(parry::clipped_runs(replay), is_beyond_range) &&
           why_malformed(lost.pair, Engine::answer(replay, lost.pair)).has_value();
  });
}

#define MANIFUZZ_OF_PARRY(predicate)                         \
  template bool predicate<parry::Floats>(const Deviation&);  \
  template bool predicate<parry::Doubles>(const Deviation&); \
  template bool predicate<parry::Rapier>(const Deviation&);  \
  template bool predicate<parry::RapierContact>(const Deviation&);

MANIFUZZ_OF_PARRY(clip_of_face_by_cosine)
MANIFUZZ_OF_PARRY(edge_along_normal)
MANIFUZZ_OF_PARRY(normal_of_corner_cones)
MANIFUZZ_OF_PARRY(contact_lost_by_epa)
MANIFUZZ_OF_PARRY(step_back_of_gjk)
MANIFUZZ_OF_PARRY(stop_of_gjk)
MANIFUZZ_OF_PARRY(touching_of_gjk)
MANIFUZZ_OF_PARRY(origin_within_tolerance)
MANIFUZZ_OF_PARRY(equal_corners_of_gjk)

template bool not_a_number_of_clip<parry::Floats>(const LostAnswer&);
template bool not_a_number_of_clip<parry::Rapier>(const LostAnswer&);

template bool normals_before_simplifying<parry::Floats>(const Deviation&);
template bool normals_before_simplifying<parry::Rapier>(const Deviation&);
template bool squared_length_of_epa<parry::Floats>(const Deviation&);

#undef MANIFUZZ_OF_PARRY

}  // namespace manifuzz
