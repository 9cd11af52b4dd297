#include "oracle/libccd/ledger/ray.hpp"

#include "judging/faults/differences.hpp"
#include "oracle/libccd/ledger/portal.hpp"

namespace manifuzz {
namespace {

using ledger_of::CcdPortalAnswer;
using ledger_of::CcdPortalEnd;

/// Whether it is what was answered, in the plane.
bool is_said_by_portal(const Deviation& d, const CcdPortalAnswer& answer) {
  if (d.got.count == 0) return false;
  const Vector2<double> translation(answer.translation.x(), answer.translation.y());
  return (ledger_of::translation_of(d) - translation).norm() <= 4 * d.right.bounds.separation;
}

}  // namespace

bool translation_to_corner_of_ray(const Deviation& d) {
  const CcdPortalAnswer answer = ledger_of::ccd_portal_penetration(d.right.pair());
  return answer.end == CcdPortalEnd::segment && is_said_by_portal(d, answer);
}

bool translation_to_portal(const Deviation& d) {
  const CcdPortalAnswer answer = ledger_of::ccd_portal_penetration(d.right.pair());
  return answer.end == CcdPortalEnd::tolerance && !answer.is_on_edge &&
         is_said_by_portal(d, answer);
}

bool translation_to_edge_of_portal(const Deviation& d) {
  const CcdPortalAnswer answer = ledger_of::ccd_portal_penetration(d.right.pair());
  return answer.end == CcdPortalEnd::tolerance && answer.is_on_edge && is_said_by_portal(d, answer);
}

}  // namespace manifuzz
