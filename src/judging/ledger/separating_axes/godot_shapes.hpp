#pragma once

#include <array>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz::as_godot {

// What Godot 3.2.3 makes of a case, its operations and the adapter's repeated in their order, in
// float: the numbers are the engine's to the last bit.

/// CMP_EPSILON.
inline constexpr double kCmpEpsilon = 1e-5;

/// Vector2::normalized, Vector2::tangent.
Vector2<float> normalized(Vector2<float> v);
Vector2<float> tangent_of(const Vector2<float>& v);

/// What of the engine is to be mended: the ledger's entries compare answers.
struct Mends {
  bool is_segment_unit = false;   ///< a segment's normal is unit
  bool is_edge_farthest = false;  ///< a polygon's edge ends at the vertex that is farthest
  bool is_along_edges = false;    ///< edges are met where they are, not at their first ends
};

/// The supports along a direction: an edge where there are two, none where there is no maximum.
struct Supports {
  std::array<Vector2<float>, 2> points{Vector2<float>(0, 0), Vector2<float>(0, 0)};
  int count = 0;
};

/// A Shape2DSW and its Transform2D.
class Shape {
 public:
  /// In the order of Physics2DServer::ShapeType.
  enum class Type { segment, circle, capsule, polygon };

  explicit Shape(const Body& body);

  Type type() const { return type_; }
  const Vector2<float>& origin() const { return origin_; }
  /// The vertices in the world; of a capsule the ends of its core.
  std::vector<Vector2<float>> corners() const;
  /// A polygon's or a segment's normals, a capsule's side.
  std::vector<Vector2<float>> normals() const;
  /// project_range.
  std::array<float, 2> range(const Vector2<float>& axis) const;
  /// get_supports, in the world.
  Supports supports(const Vector2<float>& direction, const Mends& mends) const;

 private:
  Vector2<float> placed(const Vector2<float>& v) const;
  Vector2<float> turned_back(const Vector2<float>& v) const;
  Supports local_supports(const Vector2<float>& n, const Mends& mends) const;
  Supports capsule_supports(Vector2<float> n) const;
  Supports polygon_supports(const Vector2<float>& n, const Mends& mends) const;

  Type type_;
  float radius_ = 0;
  float height_ = 0;  ///< of a capsule's core
  Vector2<float> origin_{0, 0};
  Vector2<float> x_axis_{1, 0};
  Vector2<float> y_axis_{0, 1};
  std::vector<Vector2<float>> points_;  ///< a segment's, a polygon's
};

}  // namespace manifuzz::as_godot
