#pragma once

#include <array>
#include <type_traits>

#include "geometry/manifold.hpp"
#include "oracle/parry/ledger/epa.hpp"
#include "oracle/parry/ledger/gjk.hpp"

namespace manifuzz::parry {

/// Which function collides the pair: of contact_manifolds, or contact_support_map_support_map.
enum class Route { balls, ball, capsules, features, supports };

/// A point of a ContactManifold: on both surfaces, each in its shape's frame.
template <class Real>
struct TrackedPoint {
  Vector2<Real> on_a{0, 0};
  Vector2<Real> on_b{0, 0};
  Real distance = 0;
};

/// What parry finds, and how.
template <class Real>
struct Replay {
  Route route = Route::features;
  Placed<Real> a;
  Placed<Real> b;
  Pose<Real> between;              ///< b's frame in a's
  Real prediction = 0;             ///< how far apart shapes may be whose points it gives
  bool is_swapped = false;         ///< a is the case's B
  bool is_foot_unrounded = false;  ///< mended: GJK's places on chords, before they are rounded
  std::vector<TrackedPoint<Real>> points{};
  Vector2<Real> normal{0, 0};  ///< in a's frame

  GjkResult<Real> gjk{};           ///< of features, supports, and of a ball and a polygon
  EpaResult<Real> epa{};           ///< the same
  EpaResult<Real> epa_going_on{};  ///< where it ended backward: how it would end, going on
  std::optional<EpaResult<Real>> epa_with_signs{};  ///< where it ended on a chord: with its signs
  std::array<std::size_t, 2> faces{};  ///< of features: those that are clipped, of polygons
  bool is_clipped = false;             ///< of features: they overlap along the normal's tangent
  Vector2<Real> apart{0, 0};  ///< of capsules and a ball: the difference that becomes the normal
  bool is_inside = false;     ///< of a ball: its centre is inside of the other shape
  bool is_on_core = false;    ///< of a ball and a capsule: its centre is taken to be on the core
  std::vector<TrackedPoint<Real>> both_ends{};  ///< of capsules: both ends of the clip
};

/// contact_manifold_convex_convex.
template <class Real>
Replay<Real> replayed(const Placed<Real>& a, const Placed<Real>& b, Real prediction = 0);

/// The replay of a pair, but that GJK's places on chords are not rounded as parry's are, and that
/// no corners are taken for one to which those places lead.
template <class Real>
Replay<Real> replayed_with_unrounded_feet(const Replay<Real>& replay);

/// contact without prediction: one point, of shapes with their radii.
template <class Real>
Replay<Real> replayed_contact(const Placed<Real>& a, const Placed<Real>& b);

/// The points that a replay of features would have with these faces clipped.
template <class Real>
std::vector<TrackedPoint<Real>> clipped_by(const Replay<Real>& replay,
                                           const std::array<std::size_t, 2>& faces);

/// The points that it would have with one end of a side's face, 0 or 1, for the place on it that it
/// clips: that end alone of a face that is along the normal to a bound; of another that is clipped
/// beside the end, to the bound, the other point too. None where neither is so.
template <class Real>
std::vector<TrackedPoint<Real>> clipped_at(const Replay<Real>& replay, Side side, std::size_t end,
                                           double bound);

/// The replay of a pair with a GJK that keeps the step from which it went back; none where it did
/// not, and of `supports`.
template <class Real>
std::optional<Replay<Real>> replayed_after_step(const Replay<Real>& replay);

/// The replay of a pair where EPA's distances of a chord have the signs that those of a triangle
/// have; none where it did not end on a chord, and of other routes than `features`.
template <class Real>
std::optional<Replay<Real>> replayed_with_signs(const Replay<Real>& replay);

/// How far both edges that are clipped run along the normal's tangent; of capsules, the cores.
template <class Real>
std::array<Real, 2> clipped_runs(const Replay<Real>& replay);

/// The normal that it gives of b: from b to a, in b's frame.
template <class Real>
Vector2<Real> normal_of_b(const Replay<Real>& replay) {
  return rotate_back<Real>(replay.between.rotation, Vector2<Real>(-replay.normal));
}

template <class Real>
void run_epa(Replay<Real>& replay, const Operands<Real>& operands, const Simplex<Real>& simplex) {
  replay.epa = Epa<Real>(operands, simplex).run();
  if (replay.epa.end == EpaEnd::backward) {
    replay.epa_going_on = Epa<Real>(operands, simplex).run_on();
  }
  if (replay.epa.is_of_chord) {
    replay.epa_with_signs = Epa<Real>(operands, simplex).run_with_signs();
  }
}

/// contact_support_map_support_map_with_params: the places on both, in a's frame, and the normal of
/// the replay; none of those without contact.
template <class Real>
std::optional<std::array<Vector2<Real>, 2>> searched(Replay<Real>& replay, bool is_round,
                                                     Real farthest,
                                                     Real corner_tolerance = kGjkTolerance<Real>) {
  const Operands<Real> operands{&replay.a.shape, &replay.b.shape, replay.between, is_round};
  const auto towards = try_normalize(replay.between.position).value_or(Vector2<Real>(1, 0));
  Simplex<Real> simplex(corner_along(operands, towards),
                        replay.is_foot_unrounded ? 0 : corner_tolerance);
  replay.gjk = Gjk<Real>(operands, farthest, simplex, replay.is_foot_unrounded).run();
  if (replay.gjk.is_intersection) {
    run_epa(replay, operands, simplex);
    if (replay.epa.end == EpaEnd::lost) return std::nullopt;
    replay.normal = replay.epa.normal;
    return std::array{replay.epa.on_a, replay.epa.on_b};
  }
  if (!replay.gjk.has_points) return std::nullopt;
  replay.normal = replay.gjk.direction;
  return std::array{replay.gjk.on_a, replay.gjk.on_b};
}

/// The search again by a GJK that takes no corners for one but those at one place: its direction
/// and ends, without points; of `features` and `supports`.
template <class Real>
Replay<Real> searched_without_refusals(Replay<Real> replay) {
  const Real radii = replay.prediction + replay.a.shape.radius + replay.b.shape.radius;
  const bool is_round = replay.route == Route::supports;
  replay.epa = {};
  replay.epa_going_on = {};
  replay.epa_with_signs.reset();
  replay.normal = {0, 0};
  replay.points.clear();
  searched<Real>(replay, is_round, is_round ? Real(0) : radii, 0);
  return replay;
}

}  // namespace manifuzz::parry
