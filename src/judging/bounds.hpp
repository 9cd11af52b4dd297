#pragma once

#include "collider/collider.hpp"

namespace manifuzz {

/// How far a right collider's figures may lie from the truth, by its declaration; bounds.md derives
/// them. With u the roundoff of its scalar and E the extent (plus the total radius, plus the larger
/// |position| where it rounds in the world):
///
///   separation, reference, contact boundary   15 u E   (26 in double)
///   incident dot                               9 u     (17)
///   normal                                     6 u     (12, in world coordinates 21)
///   position                                  10 u E, and 15 u E / cos at ends that are clipped or
///                                             (14)        nearly so, of the angle between incident
///   depth                                     15 u E, and 15 u E tan   edge and reference face
///                                             (26)
///
/// each plus the rotations' defect |c^2 + s^2 - 1| (times E) for a float collider, which may take
/// the transpose for the inverse, and 8 u (times E) for one that takes angles. A double one of
/// these gets scaled vertices, u off each, and with them a face's own normal.
struct Bounds {
  double separation = 0;    ///< world length; also depth's, and how near a side plane is "nearly"
  double incident_dot = 0;  ///< of two unit normals
  double normal = 0;        ///< length of the difference of two unit vectors
  double position = 0;      ///< world length, of an end that is not clipped
  double vertex = 0;        ///< a share of its length: of each that a face's normal is taken from
  double world_vertex = 0;  ///< world length, of each likewise, where it is rounded in the world
};

/// What one operation of that scalar may be off by, as a share of its result: 2^-24 or 2^-53.
double roundoff(ScalarType scalar);

/// |c^2 + s^2 - 1| of a body's rotation.
double rotation_defect(const Body& body);

Bounds bounds(const PairCase& pair, const Declaration& declaration);

/// The bounds of a pair whose extent E is known already.
Bounds bounds(const PairCase& pair, const Declaration& declaration, double extent);

/// Float cannot say: the separation bound exceeds this share of the smaller polygon's diameter.
inline constexpr double kIllPosedShare = 0.05;

inline bool is_ill_posed(double size, const Bounds& bounds) {
  return bounds.separation > kIllPosedShare * size;
}

}  // namespace manifuzz
