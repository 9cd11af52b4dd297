#pragma once

#include <array>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz::as_godot {

// What Godot 3.2.3 makes of a case, its operations and the adapter's repeated in their order, in
// float: the numbers are the engine's to the last bit.

/// CMP_EPSILON.
inline constexpr double kCmpEpsilon = 1e-5;

/// In place of an edge's number, of A or of B: the edge that Godot takes; the farthest vertex.
inline constexpr int kItsOwnEdge = -1;
inline constexpr int kNoEdge = -2;

/// What of the engine is to be mended: the ledger's entries compare answers.
struct Mends {
  bool is_segment_unit = false;   ///< a segment's normal is unit
  bool is_along_edges = false;    ///< edges are met where they are, not at their first ends
  bool is_side_tilted = false;    ///< a capsule's side lies along the normal, not its own
  bool is_foot_between = false;   ///< a point meets an edge along the normal, between its ends
  bool is_edge_exact = false;     ///< an edge's ends are not rounded in the world
  bool is_of_any_length = false;  ///< an edge is one however short
  bool is_without_start = false;  ///< the farthest vertex and the least overlap are found anywhere
  bool is_square_in_range = false;  ///< squares of lengths neither overflow nor underflow
  std::array<int, 2> edges{kItsOwnEdge, kItsOwnEdge};  ///< of the polygons A and B
};

/// Vector2::normalized, Vector2::tangent.
Vector2<float> normalized(const Vector2<float>& v, const Mends& mends);
Vector2<float> tangent_of(const Vector2<float>& v);

/// The supports along a direction, in the world: an edge where there are two, none where there is
/// no maximum.
template <class Scalar>
struct Supports {
  std::array<Vector2<Scalar>, 2> points{Vector2<Scalar>(0, 0), Vector2<Scalar>(0, 0)};
  int count = 0;
};

/// A Shape2DSW and its Transform2D.
class Shape {
 public:
  /// In the order of Physics2DServer::ShapeType.
  enum class Type { segment, circle, capsule, polygon };

  /// `edge`: of a polygon, in place of its own.
  Shape(const Body& body, const Mends& mends, int edge);

  Type type() const { return type_; }
  const Vector2<float>& origin() const { return origin_; }
  /// The vertices in the world; of a capsule the ends of its core.
  std::vector<Vector2<float>> corners() const;
  /// A polygon's or a segment's normals, a capsule's side.
  std::vector<Vector2<float>> normals() const;
  /// project_range.
  std::array<float, 2> range(const Vector2<float>& axis) const;
  /// get_supports, rounded in the world as Godot does where the scalar is float.
  template <class Scalar>
  Supports<Scalar> supports(const Vector2<float>& direction) const;
  /// What a polygon may be met by: its edges within 0.36 degrees, and none of them where none ends
  /// at the farthest vertex. Of another shape what it takes itself.
  std::vector<int> edges_met(const Vector2<float>& direction) const;

 private:
  template <class Scalar>
  Vector2<Scalar> placed(const Vector2<float>& v) const;
  Vector2<float> turned_back(const Vector2<float>& v) const;
  Vector2<float> local_direction(const Vector2<float>& v) const;
  Supports<float> local_supports(const Vector2<float>& n) const;
  Supports<float> capsule_supports(Vector2<float> n) const;
  Supports<float> polygon_supports(const Vector2<float>& n) const;
  bool is_along(int i, const Vector2<float>& n) const;

  Mends mends_;
  int edge_;
  Type type_;
  float radius_ = 0;
  float height_ = 0;  ///< of a capsule's core
  Vector2<float> origin_{0, 0};
  Vector2<float> x_axis_{1, 0};
  Vector2<float> y_axis_{0, 1};
  std::vector<Vector2<float>> points_;  ///< a segment's, a polygon's
};

}  // namespace manifuzz::as_godot
