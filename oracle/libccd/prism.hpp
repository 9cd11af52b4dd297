#pragma once

#include <algorithm>
#include <array>
#include <ccd/ccd.h>
#include <cmath>

#include "manifuzz_collider.h"

// libccd knows shapes by their support function alone, in space: a polygon is a prism along z,
// higher than any depth, so that the least depth is in the plane.

namespace manifuzz_libccd {

/// A polygon's vertices in the world, and how far the prism goes up and down.
struct Prism {
  int count = 0;
  std::array<manifuzz_double2, MANIFUZZ_VERTICES_MAX> vertices{};
  double half_height = 0;
};

inline Prism place(const manifuzz_body& body) {
  Prism prism{.count = body.count};
  const auto cos = static_cast<double>(body.rotation.x);
  const auto sin = static_cast<double>(body.rotation.y);
  for (int i = 0; i < body.count; ++i) {
    const auto x = static_cast<double>(body.vertices[i].x);
    const auto y = static_cast<double>(body.vertices[i].y);
    prism.vertices[i] = {cos * x - sin * y + static_cast<double>(body.position.x),
                         sin * x + cos * y + static_cast<double>(body.position.y)};
  }
  return prism;
}

/// How far a body reaches from its origin.
inline double reach(const manifuzz_body& body) {
  double farthest = 0;
  for (int i = 0; i < body.count; ++i) {
    farthest = std::max(farthest, std::hypot(static_cast<double>(body.vertices[i].x),
                                             static_cast<double>(body.vertices[i].y)));
  }
  return farthest;
}

/// How far prisms go up and down, as shares of both reaches: along z they overlap by more than the
/// sum of both, and in the plane, across the line between their origins, by no more than the
/// reaches.
struct HalfHeights {
  double a = 0;
  double b = 0;
};

/// ccdGJKPenetration or ccdMPRPenetration, and the prisms with which it fails least.
struct Algorithm {
  decltype(&ccdGJKPenetration) penetration;
  HalfHeights half_heights;
};

/// With equal heights the difference would be flat at the origin, where doSimplex4 gives up.
inline constexpr Algorithm kGjk{ccdGJKPenetration, {2, 1}};
/// With unequal heights, or low ones, portals are left through their caps.
inline constexpr Algorithm kMpr{ccdMPRPenetration, {16, 16}};

struct PrismPair {
  PrismPair(const manifuzz_body& body_a, const manifuzz_body& body_b, const HalfHeights& shares)
      : a(place(body_a)), b(place(body_b)) {
    const double both = reach(body_a) + reach(body_b);
    a.half_height = shares.a * both;
    b.half_height = shares.b * both;
  }

  Prism a;
  Prism b;
};

inline void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  const Prism& prism = *static_cast<const Prism*>(object);
  const double x = ccdVec3X(direction);
  const double y = ccdVec3Y(direction);
  const auto along = [&](const manifuzz_double2& vertex) { return vertex.x * x + vertex.y * y; };
  int best = 0;
  for (int i = 1; i < prism.count; ++i) {
    if (along(prism.vertices[i]) > along(prism.vertices[best])) best = i;
  }
  const auto [at_x, at_y] = prism.vertices[best];
  ccdVec3Set(farthest, at_x, at_y,
             ccdVec3Z(direction) < 0 ? -prism.half_height : prism.half_height);
}

inline void center(const void* object, ccd_vec3_t* middle) {
  const Prism& prism = *static_cast<const Prism*>(object);
  manifuzz_double2 sum{};
  for (int i = 0; i < prism.count; ++i) {
    sum.x += prism.vertices[i].x;
    sum.y += prism.vertices[i].y;
  }
  ccdVec3Set(middle, sum.x / prism.count, sum.y / prism.count, 0);
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

}  // namespace manifuzz_libccd
