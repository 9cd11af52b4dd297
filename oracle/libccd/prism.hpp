#pragma once

#include <algorithm>
#include <array>
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

  /// The vertex that is farthest along (x, y).
  const manifuzz_double2& farthest(double x, double y) const {
    const auto along = [&](const manifuzz_double2& vertex) { return vertex.x * x + vertex.y * y; };
    int best = 0;
    for (int i = 1; i < count; ++i) {
      if (along(vertices[i]) > along(vertices[best])) best = i;
    }
    return vertices[best];
  }
  manifuzz_double2 middle() const {
    manifuzz_double2 sum{};
    for (int i = 0; i < count; ++i) {
      sum.x += vertices[i].x;
      sum.y += vertices[i].y;
    }
    return {sum.x / count, sum.y / count};
  }
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

/// With equal heights the difference would be flat at the origin, where doSimplex4 gives up.
inline constexpr HalfHeights kHeightsOfGjk{2, 1};
/// With unequal heights, or low ones, portals are left through their caps.
inline constexpr HalfHeights kHeightsOfMpr{16, 16};

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

}  // namespace manifuzz_libccd
