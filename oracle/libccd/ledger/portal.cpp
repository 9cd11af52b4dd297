#include "oracle/libccd/ledger/portal.hpp"

#include <cmath>
#include <utility>

#include "oracle/libccd/ledger/prisms.hpp"

// libccd, mpr.c.

namespace manifuzz::ledger_of {
namespace {

/// mpr_tolerance of CCD_INIT, and what the adapter sets max_iterations to.
constexpr double kMprTolerance = 1e-4;
constexpr int kIterationsMax = 1000;

/// How sums are compared with 0.
bool is_zero_or_less(double value) {
  return ccd_is_zero(value) || value < 0;
}
bool is_zero_or_more(double value) {
  return ccd_is_zero(value) || value > 0;
}
bool is_below_zero(double value) {
  return value < 0 && !ccd_is_zero(value);
}

CcdVector normalized(const CcdVector& v) {
  return v * (1.0 / std::sqrt(ccd_dot(v, v)));
}

/// The middle, and the triangle that the ray from it leaves by.
struct Portal {
  const CcdPrisms& prisms;
  std::array<CcdVector, 4> v{};

  CcdVector outward() const { return normalized(ccd_cross<double>(v[2] - v[1], v[3] - v[1])); }
  CcdVector between() const { return normalized(ccd_cross<double>(v[1] - v[0], v[2] - v[0])); }
  bool is_reached(const CcdVector& v4, const CcdVector& dir) const {
    const double far = ccd_dot(v4, dir);
    const double least = std::fmin(std::fmin(far - ccd_dot(v[1], dir), far - ccd_dot(v[2], dir)),
                                   far - ccd_dot(v[3], dir));
    return ccd_equal(least, kMprTolerance) || least < kMprTolerance;
  }
  void expand(const CcdVector& v4) {
    const CcdVector across = ccd_cross<double>(v4, v[0]);
    if (ccd_dot(v[1], across) > 0) {
      v[ccd_dot(v[2], across) > 0 ? 1 : 3] = v4;
    } else {
      v[ccd_dot(v[3], across) > 0 ? 2 : 1] = v4;
    }
  }
};

/// The third corner of discoverPortal's; false where it finds them apart.
bool is_third_found(Portal& portal) {
  auto& v = portal.v;
  CcdVector dir = portal.between();
  if (ccd_dot(dir, v[0]) > 0) {
    std::swap(v[1], v[2]);
    dir *= -1.0;
  }
  for (int i = 0; i < kIterationsMax; ++i) {
    v[3] = portal.prisms.support(dir);
    if (is_zero_or_less(ccd_dot(v[3], dir))) return false;
    if (is_below_zero(ccd_dot(ccd_cross<double>(v[1], v[3]), v[0]))) {
      v[2] = v[3];
    } else if (is_below_zero(ccd_dot(ccd_cross<double>(v[3], v[2]), v[0]))) {
      v[1] = v[3];
    } else {
      return true;
    }
    dir = portal.between();
  }
  return false;
}

/// discoverPortal: `tolerance` where there is a portal to go on with.
CcdPortalEnd discover(Portal& portal) {
  auto& v = portal.v;
  v[0] = portal.prisms.middle();
  if (ccd_equal(v[0], CcdVector::Zero())) {
    v[0].x() += std::numeric_limits<double>::epsilon() * 10.0;
  }
  const CcdVector inward = normalized(v[0] * -1.0);
  v[1] = portal.prisms.support(inward);
  if (is_zero_or_less(ccd_dot(v[1], inward))) return CcdPortalEnd::none;
  const CcdVector across = ccd_cross(v[0], v[1]);
  if (ccd_is_zero(ccd_dot(across, across))) {
    return ccd_equal(v[1], CcdVector::Zero()) ? CcdPortalEnd::touch : CcdPortalEnd::segment;
  }
  const CcdVector dir = normalized(across);
  v[2] = portal.prisms.support(dir);
  if (is_zero_or_less(ccd_dot(v[2], dir)) || !is_third_found(portal)) return CcdPortalEnd::none;
  return CcdPortalEnd::tolerance;
}

/// refinePortal: whether the origin is in the portal.
bool refine(Portal& portal) {
  for (int i = 0; i < kIterationsMax; ++i) {
    const CcdVector dir = portal.outward();
    if (is_zero_or_more(ccd_dot(dir, portal.v[1]))) return true;
    const CcdVector v4 = portal.prisms.support(dir);
    if (!is_zero_or_more(ccd_dot(v4, dir)) || portal.is_reached(v4, dir)) return false;
    portal.expand(v4);
  }
  return false;
}

}  // namespace

CcdPortalAnswer ccd_portal_penetration(const PairCase& pair) {
  const CcdPrisms prisms(pair, manifuzz_libccd::kHeightsOfMpr);
  Portal portal{prisms};
  const CcdPortalEnd found = discover(portal);
  if (found == CcdPortalEnd::segment) return {found, portal.v[1]};
  if (found != CcdPortalEnd::tolerance) return {found};
  if (!refine(portal)) return {};
  for (int i = 0;; ++i) {
    const CcdVector dir = portal.outward();
    const CcdVector v4 = prisms.support(dir);
    const bool is_reached = portal.is_reached(v4, dir);
    if (is_reached || i > kIterationsMax) {
      const CcdNearest nearest =
          nearest_of_triangle<double>(CcdVector::Zero(), portal.v[1], portal.v[2], portal.v[3]);
      return {is_reached ? CcdPortalEnd::tolerance : CcdPortalEnd::exhausted, nearest.place,
              !nearest.is_within};
    }
    portal.expand(v4);
  }
}

}  // namespace manifuzz::ledger_of
