#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "exact/clip.hpp"
#include "exact/placed.hpp"

namespace manifuzz::exact {

/// A face and a vertex of the other polygon.
struct FaceAndVertex {
  FaceOf face;
  int vertex = 0;

  friend bool operator==(const FaceAndVertex&, const FaceAndVertex&) = default;
};

/// What is true of a pair case. Every comparison is exact; values are doubles, within `error`.
/// Separations S of a face, a side (the greatest of its faces) and the pair (the greater of both)
/// are world lengths.
class Truth {
 public:
  explicit Truth(const PairCase& pair);
  /// The truth of the shapes that an engine used: strictly convex, counter-clockwise. Sizes are
  /// those of the case itself; `pair` has the floats nearest to the vertices used.
  Truth(const PairCase& pair, const UsedShapes& used);
  Truth(const Truth&) = delete;  // clips refer to its pair
  Truth& operator=(const Truth&) = delete;

  const PairCase& pair() const { return pair_; }
  /// Made when it is first asked for, as `placed` is: what separations say at once needs neither.
  const StoredPair& stored() const {
    if (!stored_) stored_ = exact::stored(pair_);
    return *stored_;
  }
  double size() const;
  /// The lesser of one distance of two vertices of each shape: the size is at least that.
  double size_at_least() const;
  double extent() const { return rough_.extent; }

  /// S of the pair, a side or a face, to within an extent * 2^-48.
  double separation() const { return std::max(separation(Side::a), separation(Side::b)); }
  double separation(Side side) const { return rough_.greatest[static_cast<std::size_t>(side)]; }
  double separation(FaceOf face) const {
    return rough_.of_face[static_cast<std::size_t>(face.side)][face.index];
  }
  /// S of a side's face to well past double.
  DoubleDouble fine_separation(FaceOf face) const;

  /// The vertex of the other polygon that decides a face's separation, the first of equals.
  int support(FaceOf face) const;

  /// Whether a side has faces: all but points do.
  bool has_faces(Side side) const { return pair_[side].polygon.face_count() > 0; }
  bool has_faces() const { return has_faces(Side::a) || has_faces(Side::b); }

  /// The face of a side's greatest separation, the first of equals. The side has faces.
  FaceOf greatest(Side side) const;
  /// The pair's face of greatest separation, A's of equals. Some side has faces.
  FaceOf greatest() const {
    if (!has_faces(Side::a)) return greatest(Side::b);
    return greatest(has_faces(Side::b) && compare_lead_of_b(0) > 0 ? Side::b : Side::a);
  }

  // Comparisons of a side's S are of sides that have faces; of two points, S is minus infinity.

  /// The sign of S - offset.
  int compare_separation(double offset) const;
  /// The sign of S - (total radius + offset); at offset 0, they touch where it is not positive.
  int compare_contact(double offset) const;
  /// The sign of S_B - S_A - offset.
  int compare_lead_of_b(double offset) const;
  /// The sign of S of a side - share times S of the other - offset.
  int compare_lead(Side side, double share, double offset) const;
  /// The sign of S of a face - S of another - offset.
  int compare_separations(FaceOf face, FaceOf another, double offset) const;
  /// The sign of S of a face - S of its side - offset.
  int compare_with_greatest(FaceOf face, double offset) const;

  /// The edges of the other polygon whose unit normal's dot with the face's is within `bound` of
  /// the least.
  std::vector<int> incident_edges(FaceOf reference, double bound) const;

  /// The clip of an incident edge by a reference face; kept, so that asking again is free.
  const Clip& clip(FaceOf reference, int incident) const;

 private:
  const RoughPair& placed() const {
    if (!placed_) placed_ = place_roughly(stored());
    return *placed_;
  }
  int rough_sign(double value, double offset) const;
  int compare_separation(int radii, double offset) const;
  FaceAndVertex deepest(FaceOf face) const;

  PairCase pair_;
  // None: not asked for.
  mutable std::optional<StoredPair> stored_;
  mutable std::optional<RoughPair> placed_;
  mutable std::optional<double> size_;
  Separations rough_;
  mutable std::array<std::optional<int>, 2> greatest_;
  mutable std::array<std::array<std::optional<std::uint8_t>, kMaxVertices>, 2> support_;
  mutable std::vector<std::unique_ptr<const Clip>> clips_;
};

/// A pointer to a truth that outlives it: nothing is allocated.
inline std::shared_ptr<const Truth> unowned(const Truth& truth) {
  return {std::shared_ptr<void>(), &truth};
}

}  // namespace manifuzz::exact
