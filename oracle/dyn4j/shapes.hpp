#pragma once

#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz::as_dyn4j {

// What dyn4j 6.0.0 makes of a case, its operations and the adapter's repeated in their order: the
// numbers are the engine's to the last bit.

/// Epsilon.E.
inline constexpr double kEpsilon = 0x1p-53;

/// Vector2.normalize, which leaves what is shorter than Epsilon.E; the length, 0 of these.
double normalize(Vector2<double>& v);

/// Transform.
struct Placing {
  double cos = 1;
  double sin = 0;
  Vector2<double> at{0, 0};

  Vector2<double> turned(const Vector2<double>& v) const {
    return {cos * v.x() - sin * v.y(), sin * v.x() + cos * v.y()};
  }
  Vector2<double> turned_back(const Vector2<double>& v) const {
    return {cos * v.x() + sin * v.y(), -sin * v.x() + cos * v.y()};
  }
  Vector2<double> placed(const Vector2<double>& v) const {
    return {cos * v.x() - sin * v.y() + at.x(), sin * v.x() + cos * v.y() + at.y()};
  }
};

/// Interval.
struct Range {
  double min = 0;
  double max = 0;

  bool overlaps(const Range& other) const { return !(min > other.max || other.min > max); }
  bool contains(const Range& other) const { return other.min > min && other.max < max; }
};

/// What of getFarthestFeature is to be mended: the ledger's entries compare answers.
struct FeatureMends {
  bool is_capsule_as_long = false;  ///< its edge ends where its core does
  bool is_along_normal = false;     ///< its edge is a radius from its core along the normal
  bool is_edge_by_sine = false;     ///< of a polygon's edges, the one at the lesser angle
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
  Vector2<double> centre() const { return placing_.placed(centre_); }
  std::vector<Vector2<double>> foci() const;
  std::vector<Vector2<double>> axes(const std::vector<Vector2<double>>& foci) const;
  // Capsules normalise what these are given, as the engine's do.
  Range project(Vector2<double>& axis) const;
  Vector2<double> farthest_point(Vector2<double>& along) const;
  FarthestFeature farthest_feature(Vector2<double>& along, const FeatureMends& mends) const;

 private:
  enum class Kind { circle, segment, capsule, polygon };

  void make_capsule(const Vector2<double>& start, const Vector2<double>& end);
  void find_centre();
  std::size_t farthest_vertex(const Vector2<double>& along) const;
  Vector2<double> farthest_of_ends(const Vector2<double>& along) const;
  FarthestFeature edge_of(const Vector2<double>& first, const Vector2<double>& second,
                          const Vector2<double>& along) const;
  bool is_next_edge(std::size_t at, const Vector2<double>& along, bool by_sine) const;
  FarthestFeature capsule_feature(Vector2<double>& along, const FeatureMends& mends) const;

  Kind kind_;
  Placing placing_;
  double radius_ = 0;
  double length_ = 0;  ///< of a capsule with both caps
  Vector2<double> centre_{0, 0};
  Vector2<double> axis_{1, 0};             ///< of a capsule
  std::vector<Vector2<double>> vertices_;  ///< of a capsule its foci
  std::vector<Vector2<double>> normals_;
};

}  // namespace manifuzz::as_dyn4j
