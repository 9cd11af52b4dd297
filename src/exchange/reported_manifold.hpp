#pragma once

#include <array>
#include <optional>

#include "collider/collider.hpp"

namespace manifuzz {

/// How a file, a program or a library gives its manifolds where the contract of `Manifold` is
/// another; the defaults are a program's.
struct Conventions {
  bool has_midpoints = false;  ///< points lie halfway between both surfaces, as Box2D 3 has them
  bool normal_from_b = false;  ///< normals point from B to A
  bool normal_in_a = false;    ///< normals are in A's frame, not in the world's
  bool is_ordered = false;     ///< points are in the contract's order, and stay in theirs
};

/// A contact point as it is given: its position at least once, the rest where it is known.
struct ReportedPoint {
  std::optional<Vector2<double>> world{};  ///< its position in world coordinates
  std::optional<Vector2<double>> local{};  ///< its position in A's frame, which then counts
  double depth = 0;                        ///< a world length, >= 0
  std::optional<FeaturePair> features{};   ///< each one that its polygon has
};

/// A manifold as it is given, before any convention of it is undone.
struct ReportedManifold {
  int count = 0;                    ///< of points: 0, 1 or 2
  Vector2<double> normal{0, 0};     ///< unit
  std::optional<Side> reference{};  ///< whose face clips
  std::array<ReportedPoint, 2> points{};
};

/// The manifold by our own contract: in A's frame, its normal from A to B, its points in order.
/// What was not given stays open, and midpoints stay where they are, since only a reference face
/// tells which way the incident edge lies.
PartialManifold in_frame_of_a(const ReportedManifold& reported, const Conventions& conventions,
                              const PairCase& pair);

}  // namespace manifuzz
