#pragma once

#include <vector>

#include "judging/faults/replayed.hpp"

namespace manifuzz::as_dyn4j {

// What dyn4j makes of a case, its operations and the adapter's repeated in their order: the
// numbers are the engine's to the last bit.

/// Epsilon.E.
inline constexpr double kEpsilon = 0x1p-53;

/// Vector2.normalize, which leaves what is shorter than Epsilon.E; the length, 0 of these.
double normalize(Vector2<double>& v);

/// Interval.
struct Range {
  double min = 0;
  double max = 0;

  bool overlaps(const Range& other) const { return !(min > other.max || other.min > max); }
  bool contains(const Range& other) const { return other.min > min && other.max < max; }
};

/// What ClippingManifoldSolver, and the features that it asks for, are at fault with.
enum class FaultOfDyn4j : unsigned {
  longer_capsule = 2,    ///< the edge of a capsule is longer than its core
  normal_of_edge = 4,    ///< the normal is the reference edge's, and depths are along it
  placed_vertices = 8,   ///< the reference edge's direction is that of its placed ends
  longer_edges = 16,     ///< the edge clips whose product with the normal is least
  any_angle = 32,        ///< segments and polygons have an edge, whatever its angle
  neighbour_by_dot = 64  ///< of edges beside each other, dots of unit vectors decide
};

/// PointFeature, or EdgeFeature.
struct FarthestFeature {
  bool is_edge = false;
  Vector2<double> from{0, 0};  ///< of an edge; of a point that
  Vector2<double> to{0, 0};
  Vector2<double> max{0, 0};
  Vector2<double> along{0, 0};  ///< of the shape's own vertices, turned
  Vector2<double> edge{0, 0};   ///< the same of the placed ends, as the engine has it
};

/// A Circle, Segment, Capsule or Polygon and its Transform.
class Placed {
 public:
  explicit Placed(const Body& body);

  bool is_circle() const { return kind_ == Kind::circle; }
  bool is_capsule() const { return kind_ == Kind::capsule; }
  double radius() const { return radius_; }
  Vector2<double> centre() const { return transform(placing_, centre_); }
  std::vector<Vector2<double>> foci() const;
  std::vector<Vector2<double>> axes(const std::vector<Vector2<double>>& foci) const;
  // Capsules normalise what these are given, as the engine's do.
  Range project(Vector2<double>& axis) const;
  Vector2<double> farthest_point(Vector2<double>& along) const;
  FarthestFeature farthest_feature(Vector2<double>& along, unsigned mended) const;

 private:
  enum class Kind { circle, segment, capsule, polygon };

  void make_capsule(const Vector2<double>& start, const Vector2<double>& end);
  void find_centre();
  std::size_t farthest_vertex(const Vector2<double>& along) const;
  Vector2<double> farthest_of_ends(const Vector2<double>& along) const;
  FarthestFeature edge_of(const Vector2<double>& first, const Vector2<double>& second,
                          const Vector2<double>& along) const;
  bool is_next_edge(std::size_t at, const Vector2<double>& along, bool by_sine) const;
  FarthestFeature capsule_feature(Vector2<double>& along, unsigned mended) const;

  Kind kind_;
  Pose<double> placing_;
  double radius_ = 0;
  double length_ = 0;  ///< of a capsule with both caps
  Vector2<double> centre_{0, 0};
  Vector2<double> axis_{1, 0};             ///< of a capsule
  std::vector<Vector2<double>> vertices_;  ///< of a capsule its foci
  std::vector<Vector2<double>> normals_;
};

}  // namespace manifuzz::as_dyn4j
