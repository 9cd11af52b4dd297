#include "judging/used_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/exact/hausdorff.hpp"

namespace manifuzz {

double alteration_bound(const Body& body, ScalarType scalar) {
  constexpr double kRoundings = 5;  // bounds.md
  return (kRoundings * roundoff(scalar) + rotation_defect(body)) * reach(body.polygon);
}

std::optional<Altered> altered_by(const exact::Truth& truth, const ColliderAnswer& given) {
  const UsedShapes* const used = used_by(given.answer);
  if (used == nullptr) return std::nullopt;
  const PairCase& pair = truth.pair();
  Altered result;
  for (const Side side : {Side::a, Side::b}) {
    const exact::Alteration of_side(pair[side].polygon, (*used)[side]);
    const double bound = alteration_bound(pair[side], given.declaration.scalar);
    result.distance = std::max(result.distance, of_side.distance());
    result.is_beyond_rounding = result.is_beyond_rounding || of_side.exceeds(bound);
  }
  if (result.distance == 0) return std::nullopt;
  if (!find_defect_in_doubles(used->a.corners()) && !find_defect_in_doubles(used->b.corners())) {
    result.truth = std::make_shared<const exact::Truth>(pair, *used);
  }
  return result;
}

}  // namespace manifuzz
