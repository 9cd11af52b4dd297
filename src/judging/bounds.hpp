#pragma once

#include "geometry/collider.hpp"

namespace manifuzz {

/// How far a right collider's figures may lie from the truth, by its declaration. With u the
/// roundoff of its scalar and E the extent (plus the larger |position| where it rounds in the
/// world):
///
///   separation, reference, contact boundary   8 u E
///   incident dot, normal                      8 u
///   position                                  8 u E (1 + 1/cos)   of incident edge and reference
///   depth                                     8 u E (1 + tan)     face; the second term only at
///                                                                 ends that are clipped or nearly
///
/// each plus the rotations' defect |c^2 + s^2 - 1| (times E) for a float collider, which may take
/// the transpose for the inverse. The factor 8 covers the chains of at most seven roundings from
/// input to result; the largest error seen in millions of cases is 6.9.
struct Bounds {
  double separation = 0;    ///< world length
  double incident_dot = 0;  ///< of two unit normals
  double normal = 0;        ///< length of the difference of two unit vectors
  double length = 0;        ///< position and depth of an unclipped end, before the angle's term
};

Bounds bounds(const PairCase& pair, const Declaration& declaration);

/// The same where the extent E is known already.
Bounds bounds(const PairCase& pair, const Declaration& declaration, double extent);

/// Float cannot say: the separation bound exceeds this share of the smaller polygon's diameter.
inline constexpr double kIllPosedShare = 0.05;

bool is_ill_posed(const PairCase& pair, const Bounds& bounds);
inline bool is_ill_posed(double size, const Bounds& bounds) {
  return bounds.separation > kIllPosedShare * size;
}

}  // namespace manifuzz
