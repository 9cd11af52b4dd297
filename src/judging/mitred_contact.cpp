#include "judging/mitred_contact.hpp"

#include <algorithm>

namespace manifuzz {

bool may_touch_beyond_skins(const exact::Truth& truth, const exact::PenetrationCurve& curve,
                            double minimality, double along) {
  if (truth.compare_separation(0) <= 0) return false;
  const double slide = 2 * std::max(total_radius(truth.pair()) - along, 0.0);
  return std::ranges::any_of(curve.minima(minimality), [&](const Vector2<double>& normal) {
    return exact::Along(truth, normal).compare_gap(curve.least() - minimality, slide) < 0;
  });
}

}  // namespace manifuzz
