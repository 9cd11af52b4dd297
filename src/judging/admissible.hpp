#pragma once

#include <memory>
#include <vector>

#include "exact/truth.hpp"
#include "judging/bounds.hpp"
#include "judging/bucket.hpp"

namespace manifuzz {

/// Each clip that a face within bound of its side's greatest separation may make, whether the
/// polygons touch or not.
std::vector<const exact::Clip*> clips_within(const exact::Truth& truth, Side side,
                                             const Bounds& bounds);

/// The sign of (how far the side that the bias does not favour leads) - bias - offset.
int compare_lead_over_bias(const exact::Truth& truth, const TieBias& bias, double offset);

/// Whether the bias leaves it open, within `bound`, that a side's best face is the reference.
bool may_be_reference(const exact::Truth& truth, const TieBias& bias, Side side, double bound);

/// The side whose greatest separation is the reference under the bias.
Side reference_under(const exact::Truth& truth, const TieBias& bias);

/// Every manifold that is right for a collider: the clips it may make, and the bounds within which
/// it may make them. Whatever is compared with a bound is compared exactly.
struct Admissible {
  std::shared_ptr<const exact::Truth> truth;
  Bounds bounds;
  TieBias tie_bias{};                          ///< that references are held to
  bool must_touch = false;                     ///< S < -bound
  bool may_touch = false;                      ///< S <= total radius + bound
  bool may_be_apart = false;                   ///< S >= total radius - bound
  std::vector<const exact::Clip*> candidates;  ///< the truth's; empty where they may not touch

  const PairCase& pair() const { return truth->pair(); }
  double from_contact() const;  ///< |S - total radius|
};

/// What is right for a collider with this declaration:
/// - Faces of the side that its bias favours within bound of S of that side, unless the other's S
///   leads by more than bias + bound; the other's, if it leads by more than bias - bound. Where the
///   polygons may overlap and a clip of these may be empty, the same at bias 0 too: no bias forbids
///   to report the overlap.
/// - With each, the incident edges whose normal's dot is within bound of the least.
/// Where the scalar may overflow the bound is infinite, and nothing is decided: no candidates.
/// Round shapes are judged by the penetration curve: nor have they any.
Admissible admissible(std::shared_ptr<const exact::Truth> truth, const Declaration& declaration);
Admissible admissible(const PairCase& pair, const Declaration& declaration);
/// The right manifolds within these bounds.
Admissible admissible(std::shared_ptr<const exact::Truth> truth, const TieBias& tie_bias,
                      const Bounds& bounds);

/// How far position and depth of a candidate's point may be off: the angle's term where the end is
/// clipped or nearly so, capped by the incident edge's length.
double position_bound(const Bounds& bounds, const exact::Clip& clip, const exact::ClipPoint& point);
double depth_bound(const Bounds& bounds, const exact::Clip& clip, const exact::ClipPoint& point);
inline double position_bound(const Admissible& right, const exact::Clip& clip,
                             const exact::ClipPoint& point) {
  return position_bound(right.bounds, clip, point);
}
inline double depth_bound(const Admissible& right, const exact::Clip& clip,
                          const exact::ClipPoint& point) {
  return depth_bound(right.bounds, clip, point);
}

/// The bounds with what the normal of this clip's face may be off by, and what such a normal moves,
/// where it is taken from vertices that were rounded; and what is right within them.
Bounds bounds_of_face(const Admissible& right, const exact::Clip& clip);
Admissible with_face_of(const Admissible& right, const exact::Clip& clip);

/// Whether the incident edge misses the slab, or nearly; or the slab is narrower than rounding.
bool may_miss(const Admissible& right, const exact::Clip& clip);

/// Whether the point's depth is 0 within its bound.
bool is_at_zero_depth(const Admissible& right, const exact::Clip& clip,
                      const exact::ClipPoint& point);

/// A point that a right collider may leave out: too shallow, or of an edge that may miss the slab.
bool is_optional(const Admissible& right, const exact::Clip& clip, const exact::ClipPoint& point);

/// Whether the clip may keep nothing: it may miss, or lies in front of the face, or nearly.
bool may_be_empty(const Admissible& right, const exact::Clip& clip);

/// Whether nothing that makes the point's features is within bound: one candidate, two ends that
/// can be told apart, none of them at a side plane.
bool features_decided(const Admissible& right, const exact::Clip& clip,
                      const exact::ClipPoint& point);

/// How a manifold falls short of the right ones; `kind` none: it is one of them.
struct Mismatch {
  Kind kind = Kind::none;
  double magnitude = 0;  ///< world length (normal: length of the difference)
  double bound = 0;      ///< within which it would be right
  double missing = 0;    ///< depth of a point that is left out, a world length
};

/// Against one candidate. Features count only where nothing that decides them is within bound.
Mismatch mismatch(const Manifold<double>& manifold, const exact::Clip& clip,
                  const Admissible& right);

/// Against all of them: the closest.
Mismatch mismatch(const Manifold<double>& manifold, const Admissible& right);

/// Each of them, as far as they are decided, to the nearest double; the one without points first
/// where that is right too. An edge that misses the slab by no more than the bound gives its
/// nearest end.
std::vector<Manifold<double>> right_manifolds(const Admissible& right);

}  // namespace manifuzz
