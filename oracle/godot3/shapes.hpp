#pragma once

#include <array>
#include <vector>

#include "judging/faults/replayed.hpp"

namespace manifuzz::as_godot {

// What Godot 3 makes of a case, its operations and the adapter's repeated in their order, in
// float: the numbers are the engine's to the last bit.

/// CMP_EPSILON.
inline constexpr double kCmpEpsilon = 1e-5;

/// In place of an edge's number, of A or of B: the edge that Godot takes; the farthest vertex.
inline constexpr int kItsOwnEdge = -1;
inline constexpr int kNoEdge = -2;

/// What Godot 3 is at fault with.
enum class FaultOfGodot : unsigned {
  short_difference = 1,  ///< normal and depth are those of the difference of rounded points
  first_ends = 2,        ///< of two edges, places are on the planes through their first ends
  first_edge = 4,        ///< of a polygon's edges within 0.36 degrees the first is met
  segment_length = 8,    ///< a segment's normal is as long as the segment
  tested_axis = 16,      ///< the axis is between two rounded places, or one of several that tie
  flat_capsule = 32,     ///< a capsule within 0.0012 degrees has a side, with its normal
  uncapped_foot = 64,    ///< a point meets an edge's line where it is nearest, beyond its ends too
  rounded_ends = 128,    ///< an edge's line is that of its ends as rounded in the world
  short_edge = 256,      ///< an edge shorter than 1e-10 is its first end
  start_values = 512,    ///< supports below -1e10 and overlaps above 1e15 are not found
  squared_length = 1024  ///< the square of a length overflows or underflows
};

/// What of the engine is to be mended: the ledger's entries compare answers.
struct Mends {
  unsigned faults = 0;
  std::array<int, 2> edges{kItsOwnEdge, kItsOwnEdge};  ///< of the polygons A and B

  bool has(FaultOfGodot fault) const { return replayed::has(faults, fault); }
};

/// Vector2::normalized.
Vector2<float> normalized(const Vector2<float>& v, const Mends& mends);

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
