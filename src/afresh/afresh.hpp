#pragma once

#include <span>
#include <vector>

#include "afresh/cells.hpp"
#include "afresh/shape_table.hpp"
#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"

namespace manifuzz::scene {

/// Two bodies that touch, by their indices, a < b.
struct Touching {
  kernel::BodyPair bodies;   ///< A and B
  Manifold<float> manifold;  ///< of 1 or 2 points, in A's frame; its normal points to B
};

/// The contacts of all bodies, every pair afresh: each body's box, the boxes filed by counting, and
/// what overlaps collided. The simplest scene there is. It keeps nothing from call to call but its
/// memory. Where that runs out, calls throw std::bad_alloc: a shape is not added, and the next
/// `collide` is as right as any.
class Afresh {
 public:
  /// `tie_bias` is a length >= 0.
  explicit Afresh(float tie_bias = 0) : tie_bias_(tie_bias), shapes_(tie_bias) {}

  /// The new shape's index, or why it is refused.
  std::variant<std::uint32_t, Defect> add_shape(const ConvexPolygon<float>& polygon) {
    return shapes_.add(polygon);
  }

  /// All bodies that touch, in no particular order; valid until the next call. Shapes and poses
  /// must be free of `Defect`s.
  std::span<const Touching> collide(std::span<const kernel::Placement<float>> bodies);

  /// How many pairs of boxes overlapped.
  std::size_t pair_count() const { return pairs_.size(); }

 private:
  float tie_bias_;
  ShapeTable shapes_;
  std::vector<std::uint32_t> bodies_;  // all
  std::vector<Box> boxes_;             // by body
  Cells cells_;
  std::vector<kernel::BodyPair> pairs_;
  std::vector<Manifold<float>> manifolds_;
  std::vector<Touching> touching_;
};

}  // namespace manifuzz::scene
