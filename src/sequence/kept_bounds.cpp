#include "sequence/kept_bounds.hpp"

namespace manifuzz {
namespace {

constexpr double kOfLimits = 8;          ///< roundoffs of a limit
constexpr double kOfCarrying = 0x1p-50;  ///< what the judge itself rounds

}  // namespace

KeptBounds kept_bounds(const exact::Truth& truth, const Declaration& declaration) {
  const PairCase& pair = truth.pair();
  const double reach = truth.extent() + total_radius(pair);
  KeptBounds result;
  // Normals are of the world, whatever the frame in which the collider computes.
  Declaration in_world = declaration;
  in_world.frame = RoundingFrame::world;
  result.normal = bounds(pair, in_world, truth.extent()).normal;
  result.frame = curve_bounds(pair, declaration, truth.extent());
  const double more = result.normal - result.frame.normal;
  result.frame.normal = result.normal;
  result.frame.consistency += more * reach;
  result.frame.minimality += more * reach;
  result.gap = result.frame.consistency;
  result.birth = result.frame;
  const double anchors = 2 * result.frame.across;
  result.birth.consistency += anchors;
  result.birth.along = result.birth.across = anchors + result.frame.consistency;
  result.missing = result.birth.consistency + result.frame.minimality;
  return result;
}

double carried_normal_bound(const KeptBounds& then, const KeptBounds& now, int refreshes) {
  return 2 * refreshes * then.normal + now.normal + kOfCarrying;
}

double rounded_limit(double limit, const Declaration& declaration) {
  return limit * (1 + kOfLimits * roundoff(declaration.scalar));
}

}  // namespace manifuzz
