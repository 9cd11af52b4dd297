#pragma once

#include <vector>

#include "judging/bounds.hpp"
#include "judging/bucket.hpp"
#include "oracle/truth/truth.hpp"

namespace manifuzz {

/// A reference face and an incident edge that a right collider may take, and their true clip.
struct Candidate {
  Side reference_side = Side::a;
  int reference = 0;
  int incident = 0;
  truth::Clip clip;
};

/// Every manifold that is right for a collider, as the candidates it may clip and the bounds within
/// which it may do so.
struct Admissible {
  Bounds bounds;
  truth::Real total_radius = 0;
  truth::Real resolution = 0;    ///< world lengths nearer than this are equal to the truth
  truth::Real separation_a = 0;  ///< S_A: the greatest over A's faces, in world lengths
  truth::Real separation_b = 0;
  std::vector<Candidate> candidates;  ///< empty where the polygons are apart, beyond the bound

  truth::Real separation() const { return std::max(separation_a, separation_b); }
  Side reference() const { return separation_b > separation_a ? Side::b : Side::a; }
  bool must_touch() const { return separation() < -bounds.separation; }
  bool may_touch() const { return separation() <= total_radius + bounds.separation; }
};

/// What is right for a collider with this declaration:
/// - A's faces within bound of S_A, unless S_B > S_A + bias + bound; B's within bound of S_B, if
///   S_B > S_A + bias - bound. Where the polygons may overlap and a clip of these miss the deepest
///   vertex, the same at bias 0 too: no bias forbids to report the overlap.
/// - With each, the incident edges whose normal's dot is within bound of the least.
Admissible admissible(const PairCase& pair, const Declaration& declaration);

/// How far position and depth of a candidate's point may be off: the angle's term where the end is
/// clipped or nearly so, capped by the incident edge's length.
double position_bound(const truth::Clip& clip, const truth::ClipPoint& point, const Bounds& bounds);
double depth_bound(const truth::Clip& clip, const truth::ClipPoint& point, const Bounds& bounds);

/// Whether the incident edge misses the slab, or nearly; or the slab is narrower than rounding.
bool may_miss(const Candidate& candidate, const Bounds& bounds);

/// Whether the clip may keep nothing: it may miss, or lies in front of the face, or nearly.
bool may_be_empty(const Candidate& candidate, const Bounds& bounds);

/// How a manifold falls short of the right ones; `kind` none: it is one of them.
struct Mismatch {
  Kind kind = Kind::none;
  double magnitude = 0;  ///< world length (normal: length of the difference)
};

/// Against one candidate. Features count only where nothing that decides them is within bound.
Mismatch mismatch(const Manifold<double>& manifold, const Candidate& candidate,
                  const Admissible& admissible);

/// Against all of them: the closest.
Mismatch mismatch(const Manifold<double>& manifold, const Admissible& admissible);

}  // namespace manifuzz
