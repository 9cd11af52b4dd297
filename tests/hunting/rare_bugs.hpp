#pragma once

#include <span>
#include <string_view>

#include "exact/truth.hpp"
#include "hunting/conditions.hpp"

namespace manifuzz::test {

/// What a planted bug may look at: the case, and its exact clip where it has one.
struct BugView {
  const PairCase& pair;
  double size = 0;
  double depth = 0;  ///< total radius - separation, a world length
  exact::FaceOf reference{};
  const exact::Clip* clip = nullptr;  ///< none where a side has no faces
  double face_length = 0;
  const exact::Truth& truth;

  const ConvexPolygon<float>& shape(Side side) const { return pair[side].polygon; }
  bool has_counts(int of_a, int of_b) const {
    return pair.a.polygon.count == of_a && pair.b.polygon.count == of_b;
  }
  bool is_cut(int end) const { return clip->cuts[end] != exact::Cut::inside; }
  bool are_both_cut() const { return is_cut(0) && is_cut(1) && !clip->misses(); }
  bool is_one_cut() const { return is_cut(0) != is_cut(1); }
};

/// A bug that a collider may have: where it is wrong. Those that need a clip are asked only where
/// there is one.
struct RareBug {
  std::string_view name;
  std::string_view description;
  bool needs_clip = true;
  bool (*is_met)(const BugView& view) = nullptr;
};

std::span<const RareBug> rare_bugs();

/// The bugs that a case meets: bit i is set for bug i. It meets none if the shapes do not touch, or
/// if the bound of separations in float exceeds 5% of the size.
std::uint64_t rare_bugs_met_by(const exact::Truth& truth);

}  // namespace manifuzz::test
