#pragma once

#include <variant>
#include <vector>

#include "kernel/shape_rows.hpp"
#include "kernel/shapes.hpp"
#include "scene/body.hpp"

namespace manifuzz::scene {

/// What the broad phase and the certificates ask of a shape. Lengths, rounded up.
struct ShapeFacts {
  float reach = 0;   ///< the largest |vertex|
  float radius = 0;  ///< as given, not rounded
  /// How far a box must reach beyond the polygon in it, so that bodies whose boxes do not overlap
  /// have no contact by the kernel's rounded arithmetic (certificates.md, "Boxes").
  float padding = 0;
};

/// The polygons of a scene, laid out for both kernels.
class ShapeTable {
 public:
  /// `tie_bias` is the kernels', a length >= 0: it takes part in what a shape's padding must cover.
  explicit ShapeTable(float tie_bias) : tie_bias_(tie_bias) {}

  /// The new shape's index. The polygon must be free of `PolygonDefect`s.
  std::variant<std::uint32_t, Defect> add(const ConvexPolygon<float>& polygon);

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

}  // namespace manifuzz::scene
