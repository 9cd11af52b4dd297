#pragma once

#include <memory>
#include <optional>

#include "judging/compare.hpp"

namespace manifuzz {

/// What an answer says of the shapes that it used.
struct Altered {
  double distance = 0;  ///< Hausdorff, the farther side's; a world length
  double bound = 0;     ///< of that distance, the larger side's
  bool is_beyond_rounding = false;
  /// The truth of the shapes used, by which the answer is judged; none where they are no polygons,
  /// or ill posed.
  std::shared_ptr<const exact::Truth> truth;
};

/// By how much the vertices of a polygon may move where they are made a collider's own: taken to
/// its centre and back, and scaled by what the rotation is short of unit.
double alteration_bound(const Body& body, ScalarType scalar);

/// None where it used the case's polygons, or does not say.
std::optional<Altered> altered_by(const exact::Truth& truth, const ColliderAnswer& given);

}  // namespace manifuzz
