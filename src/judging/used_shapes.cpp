#include "judging/used_shapes.hpp"

#include <algorithm>
#include <limits>

#include "exact/hausdorff.hpp"

namespace manifuzz {

namespace {

/// With round corners as few vertices as any shape may have, all unlike.
bool is_round_shape(const UsedVertices& used) {
  return used.count == 1 ? *used.round_radius > 0 : used.all[0] != used.all[1];
}

/// One that floats can hold, too.
bool is_shape(const UsedVertices& used) {
  constexpr auto most = static_cast<double>(std::numeric_limits<float>::max() / 4);
  const bool is_round = used.round_radius && used.count < kMinVertices;
  return (is_round ? is_round_shape(used) : !find_defect_in_doubles(used.corners())) &&
         std::ranges::all_of(used.corners(),
                             [](const auto& v) { return v.cwiseAbs().maxCoeff() <= most; });
}

}  // namespace

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
    result.bound = std::max(result.bound, bound);
    result.is_beyond_rounding = result.is_beyond_rounding || of_side.exceeds(bound);
  }
  if (result.distance == 0) return std::nullopt;
  if (!is_shape(used->a) || !is_shape(used->b)) return result;
  const auto of_used = std::make_shared<const exact::Truth>(pair, *used);
  const Bounds within = bounds(of_used->pair(), given.declaration, of_used->extent());
  if (!is_ill_posed(of_used->size(), within)) result.truth = of_used;
  return result;
}

}  // namespace manifuzz
