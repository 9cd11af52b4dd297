#pragma once

#include <array>
#include <span>

#include "geometry/manifold.hpp"
#include "oracle/exact/placed.hpp"
#include "oracle/exact/quadratic.hpp"

namespace manifuzz::exact {

/// Where an end of the incident edge lies along the reference face.
enum class Cut { before, inside, beyond };

/// A contact point's true place, in a number type.
template <class Number>
struct Located {
  Point<Element<Number>> position;  ///< in A's frame
  Element<Number> depth;            ///< total radius - separation, a world length
};

/// An end of the incident edge inside the slab, before the face decides whether it is kept.
struct ClipPoint {
  int end = 0;  ///< 0 or 1, along the reference face
  bool crossing = false;
  FeaturePair features;
  Located<Approximate<double>> located;

  Vector2<double> position() const { return {located.position.x.value, located.position.y.value}; }
  double depth() const { return located.depth.value; }
};

/// The clip of one incident edge by one reference face, the slab widened by the total radius as in
/// Box2D. Values are doubles; which end is cut is exact.
struct Clip {
  const PairCase* pair = nullptr;  ///< whose polygons these are
  FaceOf reference;
  int incident = 0;
  std::array<Cut, 2> cuts{};
  Vector2<double> normal{0, 0};  ///< unit, A to B, in A's frame
  double cosine = 0;             ///< of the angle between incident edge and reference face, >= 0
  double tangent = 0;            ///< of the same, >= 0; its own, for 1 - cos^2 loses small angles
  double edge_length = 0;        ///< of the incident edge
  std::array<Approximate<double>, 2> along;  ///< of each end, from the first side plane inwards
  Approximate<double> width;                 ///< between the side planes
  int count = 0;  ///< 2, or 1 where the edge misses: then its nearest end, unclipped
  std::array<ClipPoint, 2> points;  ///< along the reference face's direction

  /// Whether the incident edge lies outside one of the side planes.
  bool misses() const { return cuts[0] == cuts[1] && cuts[0] != Cut::inside; }
  /// By how much the edge misses the slab; negative: how far it reaches in.
  double gap() const;
  /// The incident vertex at an end of the edge.
  int vertex(int end) const;
};

/// Its `count` points.
inline std::span<const ClipPoint> points_of(const Clip& clip) {
  return {clip.points.data(), static_cast<std::size_t>(clip.count)};
}

/// The clip refers to the pair, which must outlive it.
Clip clip(const PairCase& pair, FaceOf reference, int incident);

/// The clip as a manifold, its figures right to the last digit of double: the ends that lie behind
/// the face; of an edge that misses the slab by more than `slack`, none.
Manifold<double> true_manifold(const Clip& clip, double slack = 0);

// Exact comparisons of what the clip is made of; each gives the sign of the difference.

/// Gap - length.
int compare_gap(const Clip& clip, double length);
/// Width of the slab - length.
int compare_width(const Clip& clip, double length);
/// Distance, along the face, from an unclipped end to the nearest side plane - length.
int compare_margin(const Clip& clip, int end, double length);

/// Depth of a point - length.
int compare_depth(const Clip& clip, const ClipPoint& point, double length);
/// Whether a reported figure lies no farther than `bound` from the true one; never where it is not
/// finite.
bool is_near_position(const Clip& clip, const ClipPoint& point, const Vector2<double>& position,
                      double bound);
bool is_near_depth(const Clip& clip, const ClipPoint& point, double depth, double bound);
bool is_near_normal(const Clip& clip, const Vector2<double>& normal, double bound);
/// The distance between both points - length.
int compare_apart(const Clip& clip, double length);

}  // namespace manifuzz::exact
