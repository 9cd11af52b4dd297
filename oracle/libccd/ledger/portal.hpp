#pragma once

#include "geometry/pair_case.hpp"
#include "oracle/libccd/ledger/simplex.hpp"

namespace manifuzz::ledger_of {

/// How ccdMPRPenetration comes to its answer.
enum class CcdPortalEnd {
  none,       ///< no intersection
  touch,      ///< findPenetrTouch: the origin is the first corner
  segment,    ///< findPenetrSegment: it is on the way to the first corner
  tolerance,  ///< findPenetr: the portal is within the tolerance of the corner beyond it
  exhausted,  ///< findPenetr: after max_iterations
};

/// The translation, as its place, and how it came about.
struct CcdPortalAnswer {
  CcdPortalEnd end = CcdPortalEnd::none;
  CcdVector translation{0, 0, 0};
  bool is_on_edge = false;  ///< of the last portal, and not within it
};

/// ccdMPRPenetration of mpr.c, in its own doubles.
CcdPortalAnswer ccd_portal_penetration(const PairCase& pair);

}  // namespace manifuzz::ledger_of
