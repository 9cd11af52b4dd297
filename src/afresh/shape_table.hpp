#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "afresh/defect.hpp"
#include "kernel/shapes.hpp"

namespace manifuzz::scene {

// The constants of certificates.md, which derives them.

/// The roundoff of a float.
inline constexpr float kRoundoff = std::numeric_limits<float>::epsilon() / 2;

/// How far a face's separation as the kernel rounds it may be from the same of the exact poses, as
/// a share of the extent: 15 u, and the defect of two rotations.
inline constexpr float kSeparationError = 15 * kRoundoff + 2.1e-5F;

/// More than all that is lost to underflow.
inline constexpr float kUnderflow = 64 * std::numeric_limits<float>::min();

/// More than sqrt(2) - 1: of a vector's two sides the greater, and so much of the lesser, are
/// together at least as long as the vector.
inline constexpr float kLesserSide = 0.41422F;

/// At least |v|, at most 8% more; without a square, which could underflow.
inline float length_at_most(const Vector2<float>& v) {
  const float x = std::abs(v.x());
  const float y = std::abs(v.y());
  return std::max(x, y) + kLesserSide * std::min(x, y);
}

/// More than the roundings of a displacement.
inline constexpr float kRoundUp = 1.001F;

/// Less than the roundings of a difference of two floats add.
inline constexpr float kRoundDown = 0.999F;

/// At least how far any vertex of a polygon of this reach (a length) has moved from one pose to
/// another, both in one frame; a length.
inline float displacement(const Pose<float>& from, const Pose<float>& to, float reach) {
  return kRoundUp * (length_at_most(to.position - from.position) +
                     reach * length_at_most(to.rotation - from.rotation));
}

/// The next float above a length.
inline float next_float(float length) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(length) + 1);
}

/// What boxes and proofs ask of a shape. Lengths, rounded up.
struct ShapeFacts {
  float reach = 0;   ///< the largest |vertex|
  float radius = 0;  ///< as given, not rounded
  /// How large it is: a circle's reach may be 0.
  float extent() const { return reach + radius; }
  /// How far a box must reach beyond the core in it, so that bodies whose boxes do not overlap
  /// have no contact by the kernel's rounded arithmetic (certificates.md, "Boxes").
  float padding = 0;
  /// Its part of what is taken off a separation of two cores before it proves that they stay apart
  /// until their paths are longer by the rest (certificates.md, "A gap that the kernel found").
  float clearance = 0;
  /// Its part of what a separation must exceed for the kernel to find no contact where they are now
  /// (certificates.md, "A face that lay between them").
  float clearance_now = 0;
};

/// The shapes of a scene, laid out for both kernels.
class ShapeTable {
 public:
  /// `tie_bias` is the kernels', a length >= 0: it takes part in what a shape's padding must cover.
  explicit ShapeTable(float tie_bias) : tie_bias_(tie_bias) {}

  /// The new shape's index, or why it is refused; nothing has changed where it is, or where memory
  /// runs out, which throws std::bad_alloc.
  std::variant<std::uint32_t, Defect> add(const ConvexPolygon<float>& shape);

  /// How many shapes there are: their indices are below it.
  std::size_t size() const { return facts_.size(); }
  /// A shape's facts; its rows for one pair at a time; all shapes for many pairs at once.
  const ShapeFacts& facts(std::uint32_t shape) const { return facts_[shape]; }
  const kernel::ShapeRows& rows(std::uint32_t shape) const { return rows_[shape]; }
  const kernel::Shapes<float>& for_pairs() const { return for_pairs_; }

 private:
  float tie_bias_;
  std::vector<ShapeFacts> facts_;
  std::vector<kernel::ShapeRows> rows_;
  kernel::Shapes<float> for_pairs_;
};

/// Parallel to the axes of the world, with its edge; world lengths.
struct Box {
  float x_min = 0;
  float y_min = 0;
  float x_max = 0;
  float y_max = 0;
};

/// Overlaps no box.
inline constexpr Box kNowhere{
    std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
    -std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};

/// Whether two boxes have a point in common; without branches, which no processor could foretell
/// here.
inline bool overlap(const Box& p, const Box& q) {
  const int in_x = static_cast<int>(p.x_min <= q.x_max) & static_cast<int>(q.x_min <= p.x_max);
  const int in_y = static_cast<int>(p.y_min <= q.y_max) & static_cast<int>(q.y_min <= p.y_max);
  return (in_x & in_y) != 0;
}

/// Whether no point of the inner box is outside the outer one.
inline bool contains(const Box& outer, const Box& inner) {
  return outer.x_min <= inner.x_min && outer.y_min <= inner.y_min && outer.x_max >= inner.x_max &&
         outer.y_max >= inner.y_max;
}

/// How far the inner box may grow all round without leaving the outer one, rounded down.
inline float slack(const Box& outer, const Box& inner) {
  const float x = std::min(inner.x_min - outer.x_min, outer.x_max - inner.x_max);
  const float y = std::min(inner.y_min - outer.y_min, outer.y_max - inner.y_max);
  return kRoundDown * std::min(x, y);
}

/// How far two boxes are apart in x or in y, whichever is more, rounded down; below 0 where they
/// overlap.
inline float gap(const Box& p, const Box& q) {
  const float x = std::max(p.x_min - q.x_max, q.x_min - p.x_max);
  const float y = std::max(p.y_min - q.y_max, q.y_min - p.y_max);
  return kRoundDown * std::max(x, y);
}

/// The box, larger by a length on each of its sides.
inline Box grown(const Box& box, float by) {
  return {box.x_min - by, box.y_min - by, box.x_max + by, box.y_max + by};
}

}  // namespace manifuzz::scene
