#pragma once

#include <optional>
#include <vector>

#include "exact/placed.hpp"
#include "judging/ledger.hpp"

namespace manifuzz {
namespace parry {

template <class Real>
struct Replay;

// The colliders whose answers are replayed.

/// parry2d 0.30.2 as its adapters ask it, in a scalar.
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
/// rapier2d-compat 0.21.0, which has parry2d 0.31.1 inside, asked for contact manifolds.
struct Rapier {
  using Real = float;
  /// As of `AsAdapters`.
  static std::vector<Replay<Real>> replays(const exact::StoredPair& pair);
  static std::vector<Replay<Real>> replays_of_simplified(const exact::StoredPair& pair);
  static Vector2<double> direction(const Replay<Real>& replay, const PairCase& pair);
  static Manifold<double> answer(const Replay<Real>& replay, const PairCase& pair);
  static const Declaration& declaration();
};
/// Rapier asked by contactCollider.
struct RapierContact {
  using Real = float;
  /// As of `AsAdapters`.
  static std::vector<Replay<Real>> replays(const exact::StoredPair& pair);
  static Vector2<double> direction(const Replay<Real>& replay, const PairCase& pair);
  static Manifold<double> answer(const Replay<Real>& replay, const PairCase& pair);
  static const Declaration& declaration();
};
using Floats = AsAdapters<float>;
using Doubles = AsAdapters<double>;

}  // namespace parry

// What the ledger's entries on parry look for. Each repeats all that parry does with the case, in
// its order and its scalar, requires that this gives the answer, and sees where it left: then
// holds what the named fault allows against the truth, or mends it.

/// With other faces clipped the direction would be right, or that of the face from which EPA
/// is off by its tolerance: the nearest by cosine was taken.
template <class Engine>
bool clip_of_face_by_cosine(const Deviation& deviation);
/// Corners were dropped, and the faces that are left have the normals that they had before: with
/// their own the answer would be right.
template <class Engine>
bool normals_before_simplifying(const Deviation& deviation);
/// One of the clipped edges is along the normal, to a bound, and one of its ends alone would be
/// right: another place on it was taken. Or the place taken on an edge is beside its end, to the
/// bound, and with the end it would be right: the edge is so nearly along the normal.
template <class Engine>
bool edge_along_normal(const Deviation& deviation);
/// EPA of a simplex of one corner: a normal that is outside of a corner's cone. A round corner's is
/// a single direction.
template <class Engine>
bool normal_of_corner_cones(const Deviation& deviation);
/// No contact: EPA's first faces, or a new one, have the origin outside, and it gives None.
template <class Engine>
bool contact_lost_by_epa(const Deviation& deviation);
/// The normal is the direction between places on cores that are apart: off by their roundings over
/// the distance. The depth is right.
template <class Engine>
bool direction_of_parry_places(const Deviation& deviation);
/// GJK went back from a step that does not lessen the distance as floats have it: the place before
/// it is off by the root of what they tell. With the step the answer is right, or short of that by
/// no more than GJK's tolerance.
template <class Engine>
bool step_back_of_gjk(const Deviation& deviation);
/// GJK stopped within its relative tolerance of the distance.
template <class Engine>
bool stop_of_gjk(const Deviation& deviation);
/// GJK took for touching what is within its relative tolerance of the farthest support point.
template <class Engine>
bool touching_of_gjk(const Deviation& deviation);
/// EPA gives the first new face that is nearer than the one it came from: the origin was within
/// GJK's tolerance of the simplex, or, if it had gone on, it would have ended within its own. Or
/// the simplex is a chord, of whose sides it takes the farther one for the nearer, and with the
/// signs of both mended the answer is right.
template <class Engine>
bool origin_within_tolerance(const Deviation& deviation);
/// GJK's simplex refused a corner that is not where another is, and the search ended.
template <class Engine>
bool equal_corners_of_gjk(const Deviation& deviation);

/// GJK ended with a chord to which its direction leads back, without having converged: the origin's
/// place on it is rounded, and in a wider scalar the answer is right.
template <class Engine>
bool rounded_foot_of_gjk(const Deviation& deviation);

/// Two capsules: both ends of the clip would be right; one point is missing or another was taken.
template <class Engine>
bool second_point_of_parry_capsules(const Deviation& deviation);
/// Two capsules whose cores overlap, or touch to rounding: their distance gives the normal.
template <class Engine>
bool crossing_of_parry_capsules(const Deviation& deviation);
/// Two capsules whose nearest places are off by roundings over the square of the sine between both.
template <class Engine>
bool nearly_parallel_parry_capsules(const Deviation& deviation);
/// A circle whose centre EPA projects on the end of a chord instead of its nearest place.
template <class Engine>
bool corner_of_epa_chord(const Deviation& deviation);
/// A circle whose centre is on the other's surface, or core: the normal is a direction of
/// roundings, or that from the other's origin.
template <class Engine>
bool centre_on_surface(const Deviation& deviation);
/// A circle whose centre GJK projects on a polygon within its relative tolerance.
template <class Engine>
bool circle_by_gjk_stop(const Deviation& deviation);
/// EPA's faces have no normal: the square of a length is beyond the scalar's range.
template <class Engine>
bool squared_length_of_epa(const Deviation& deviation);
/// An answer that holds no number: the clip divides by an edge's run along the tangent, whose
/// reciprocal is infinite.
template <class Engine>
bool not_a_number_of_clip(const LostAnswer& lost);
/// EPA ends on a chord that is inside of the surface: the depth is too small, and the places are
/// not on it. Of contact manifolds, a circle's centre and a rounded polygon alone.
template <class Engine>
bool chord_of_epa(const Deviation& deviation);

}  // namespace manifuzz
