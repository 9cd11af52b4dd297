#pragma once

#include <ccd/ccd.h>
#include <cmath>

#include "oracle/libccd/prism.hpp"

namespace manifuzz_libccd {

/// ccdGJKPenetration or ccdMPRPenetration, and the prisms with which it fails least.
struct Algorithm {
  decltype(&ccdGJKPenetration) penetration;
  HalfHeights half_heights;
};

inline constexpr Algorithm kGjk{ccdGJKPenetration, kHeightsOfGjk};
inline constexpr Algorithm kMpr{ccdMPRPenetration, kHeightsOfMpr};

inline void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  const Prism& prism = *static_cast<const Prism*>(object);
  const auto& [x, y] = prism.farthest(ccdVec3X(direction), ccdVec3Y(direction));
  ccdVec3Set(farthest, x, y, ccdVec3Z(direction) < 0 ? -prism.half_height : prism.half_height);
}

inline void center(const void* object, ccd_vec3_t* middle) {
  const auto [x, y] = static_cast<const Prism*>(object)->middle();
  ccdVec3Set(middle, x, y, 0);
}

struct Penetrated {
  int status = -1;  ///< 0 where they intersect
  double depth = 0;
  ccd_vec3_t direction{};
  ccd_vec3_t position{};
};

/// The tolerances are those of CCD_INIT; without a limit GJK may not end. EPA knows none.
inline constexpr unsigned long kIterationsMax = 1000;

inline Penetrated ask(const Algorithm& algorithm, const PrismPair& pair) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = center;
  ccd.max_iterations = kIterationsMax;
  Penetrated found;
  found.status = algorithm.penetration(&pair.a, &pair.b, &ccd, &found.depth, &found.direction,
                                       &found.position);
  return found;
}

/// Its answer in the plane: what its translation along z is, is left out. Returns what
/// manifuzz_collide does.
inline int collide_prisms(const Algorithm& algorithm, const manifuzz_body& a,
                          const manifuzz_body& b, manifuzz_manifold& manifold) {
  const Penetrated found = ask(algorithm, PrismPair(a, b, algorithm.half_heights));
  if (found.status != 0) return 0;
  const double x = ccdVec3X(&found.direction);
  const double y = ccdVec3Y(&found.direction);
  const double in_plane = std::hypot(x, y);
  // Shapes that touch have no direction in MPR, as findPenetrTouch says of a depth of 0, and
  // findPenetr of one below CCD_EPS.
  if (in_plane == 0 && ccdVec3Z(&found.direction) == 0) return 0;
  if (std::abs(ccdVec3Z(&found.direction)) > in_plane) return 1;
  manifold.touching = 1;
  manifold.normal = {x / in_plane, y / in_plane};
  manifold.depth = found.depth * in_plane;
  return 0;
}

/// ccd.h says nothing of where its position lies, but that force should take a place there: it is
/// not judged.
constexpr manifuzz_claims claims_of_separation(double tolerance, const char* source,
                                               double least_depth = 0) {
  manifuzz_claims claims{};
  claims.answers = MANIFUZZ_CLAIMS_SEPARATION;
  claims.least_depth = least_depth;
  claims.tolerance_absolute = tolerance;
  claims.tolerance_source = source;
  return claims;
}

/// What a collider of this folder declares.
constexpr manifuzz_declaration declaration(const char* name, const char* version,
                                           const char* snippet, const manifuzz_claims& claims) {
  return {.interface = MANIFUZZ_INTERFACE,
          .name = name,
          .version = version,
          .scalar = MANIFUZZ_FLOAT64,
          .rounds_in = MANIFUZZ_WORLD,
          .answers_in = MANIFUZZ_WORLD,
          .points = MANIFUZZ_CLIP_POINTS,
          .normal = MANIFUZZ_A_TO_B,
          .tie_bias = 0,
          .vertices_max = MANIFUZZ_VERTICES_MAX,
          .takes_radius = 0,
          .snippet = snippet,
          .claims = claims};
}

}  // namespace manifuzz_libccd
