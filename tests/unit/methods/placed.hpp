#pragma once

#include <rapidcheck.h>

#include "generating/regime.hpp"
#include "judging/judge.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz::test {

template <class Scalar>
ConvexPolygon<Scalar> shape(std::vector<Vector2<Scalar>> vertices, Scalar radius = 0,
                            Rounding rounding = Rounding::mitre) {
  return make_polygon<Scalar>(vertices, radius, rounding);
}

/// A box of half width 1, around a place.
inline ConvexPolygon<double> box_at(double x, double y) {
  return shape<double>({{x - 1, y - 1}, {x + 1, y - 1}, {x + 1, y + 1}, {x - 1, y + 1}});
}

/// A case of any of these regimes.
inline PairCase any_pair(std::span<const Regime> regimes) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto index = *rc::gen::inRange<std::size_t>(0, regimes.size());
  return generate(seed, regimes[index], 0);
}

/// Whether nobody finds a fault with a collider's answer.
inline bool is_right(const PairCase& pair, const Collider& collider) {
  return judge(pair, collider, make_clip64()).bucket.fault == Fault::none;
}

/// The bound of a float collider's separation, a world length; none where floats cannot say.
inline std::optional<double> separation_bound(const PairCase& pair) {
  const Bounds within = bounds(pair, make_gjk().declaration);
  if (is_ill_posed(exact::Truth(pair).size(), within)) return std::nullopt;
  return within.separation;
}

}  // namespace manifuzz::test
