#include "judging/ledger/bullet/ccd_deviations.hpp"

#include <cmath>

#include "judging/ledger/bullet/ccd_polytope.hpp"
#include "judging/ledger/differences.hpp"

namespace manifuzz {
namespace {

using ledger_of::CcdAnswer;
using ledger_of::CcdEnd;

/// epa_tolerance of CCD_INIT.
constexpr double kToleranceOfEpa = 1e-4;

/// Whether it is what was answered, in the plane.
bool is_said_by_ccd(const Deviation& d, const CcdAnswer& answer) {
  if (d.got.count == 0 || answer.end == CcdEnd::none) return false;
  // Its direction is the element's place over its length, and its depth this length.
  const Vector2<double> translation(answer.nearest.place.x(), answer.nearest.place.y());
  return (ledger_of::translation_of(d) - translation).norm() <= 4 * d.right.bounds.separation;
}

}  // namespace

bool polytope_left_by_squares(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  const double length = answer.end == CcdEnd::along
                            ? answer.beyond / std::sqrt(answer.nearest.square)
                            : std::sqrt(answer.beyond);
  const bool is_by_tolerance = answer.end == CcdEnd::along || answer.end == CcdEnd::near;
  return is_by_tolerance && length >= kToleranceOfEpa && is_said_by_ccd(d, answer);
}

bool polytope_left_at_own_corner(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  return answer.end == CcdEnd::near && std::sqrt(answer.beyond) < kToleranceOfEpa &&
         is_said_by_ccd(d, answer);
}

bool polytope_left_at_zero(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  return answer.end == CcdEnd::zero && is_said_by_ccd(d, answer);
}

bool polytope_left_touching(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  return answer.end == CcdEnd::touching && is_said_by_ccd(d, answer);
}

}  // namespace manifuzz
