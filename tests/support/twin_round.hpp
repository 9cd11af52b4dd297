#pragma once

#include <optional>

#include "support/twin_facts.hpp"

// Round pairs, written a second time by what bounds.md says of them, and by nothing that is clever:
// distances over every vertex and every edge, squared and rational; all else real numbers.

namespace manifuzz::twin {

inline constexpr Side kSides[] = {Side::a, Side::b};

/// The sign of a number, and its square: greater for the greater number.
inline Ratio signed_square(const Ratio& value) {
  return value < 0 ? Ratio(-value * value) : Ratio(value * value);
}

/// A round pair, whoever is asked about it.
class RoundTwin {
 public:
  explicit RoundTwin(const PairCase& pair);

  /// Whether the distance of the cores, squared, is at most the total radius, squared.
  bool touches() const { return is_deep() || squared_ <= radius_ * radius_; }
  /// The side of the greatest separation.
  Side reference() const { return reference_; }
  /// What is wrong with a manifold of a collider that declares itself so.
  Kind wrong(const Declaration& declaration, const Manifold<double>& manifold) const;

 private:
  friend class RoundVerdict;

  const Outline& of(Side side) const { return side == Side::a ? a_ : b_; }
  /// The greatest separation of some faces.
  struct Greatest {
    Ratio squared;  ///< times its magnitude
    Real separation;
  };
  const std::optional<Greatest>& greatest_of(Side side) const {
    return greatest_[side == Side::a ? 0 : 1];
  }
  /// The greatest separation of all faces; none of two points.
  const std::optional<Greatest>& greatest() const { return greatest_of(reference_); }
  /// Whether cores overlap: faces decide then.
  bool is_deep() const { return greatest() && greatest()->squared < 0; }
  void look_at_vertices();
  void look_at_edges(Side side);
  void look_at_faces(Side side);

  const PairCase& pair_;
  Exact turn_of_a_;
  Outline a_;
  Outline b_;
  Ratio radius_;
  Ratio squared_;                    ///< of the least distance between both outlines
  Exact apart_;                      ///< from A's place to B's, where they are nearest
  bool is_between_vertices_ = true;  ///< that two vertices are as near as any places
  std::array<std::optional<Greatest>, 2> greatest_;  ///< of A's faces, and of B's
  Side reference_ = Side::a;
};

}  // namespace manifuzz::twin
