#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "judging/by_curve.hpp"
#include "judging/judge.hpp"
#include "judging/used_shapes.hpp"
#include "own_colliders/own_colliders.hpp"

// Wrong answers of every claim, each made from a right one. A mistake says nothing of a case in
// which it makes no difference that exceeds ten bounds.

namespace manifuzz::mistakes {

inline constexpr double kClearly = 10;  // in bounds

/// A case, its truth, and what is right.
struct Right {
  explicit Right(const PairCase& pair)
      : truth(std::make_shared<const exact::Truth>(pair)),
        curve(*truth, exact::skin_of(*truth)),
        normal(curve.minima(0).front()),
        depth(curve.least()),
        manifold(std::get<Manifold<double>>(make_clip64().collide(pair))),
        deepest(manifold.points[1].depth > manifold.points[0].depth ? 1 : 0) {}

  std::shared_ptr<const exact::Truth> truth;
  exact::PenetrationCurve curve;
  Vector2<double> normal;
  double depth;
  Manifold<double> manifold;
  int deepest;

  const PairCase& pair() const { return truth->pair(); }
  CurveBounds bounds(const Declaration& by) const {
    return curve_bounds(pair(), by, truth->extent());
  }
  double at(const Vector2<double>& n) const { return exact::Along(*truth, n).depth(); }
  bool is_clear(double difference, const Declaration& by) const {
    return std::abs(difference) > kClearly * bounds(by).minimality;
  }
  /// Whether a normal from B to A is no right one: on segments that lie on each other it is.
  bool can_be_reversed(const Declaration& by) const { return is_clear(at(-normal) - depth, by); }
  /// Farther than both shapes reach.
  double beyond() const { return 2 * (truth->extent() + total_radius(pair())); }
  bool overlaps(const Declaration& by) const { return depth > kClearly * bounds(by).minimality; }
  Penetration along(const Vector2<double>& n, double how_deep) const {
    return {.touches = true, .normal = n, .depth = how_deep};
  }
  Manifold<double> only(int point) const {
    Manifold<double> one = manifold;
    one.points[0] = manifold.points[point];
    one.count = 1;
    return one;
  }
};

using Given = std::optional<Answer>;

/// One mistake: in whose answers, how it is made, and what it must be called.
struct Mistake {
  const char* name;
  Declaration (*declared)();
  Given (*wrong)(const Right& right, const Declaration& declaration);
  std::vector<Kind> kinds;
  /// Where round shapes' cores are apart, so that their distance is the depth; none: the same.
  std::vector<Kind> kinds_apart = {};
  std::optional<float> radius = 0.0F;  ///< none: the regime's own
};

std::vector<Mistake> of_separations();
std::vector<Mistake> of_points();

/// That claim, in double, in A's frame; it clips nothing.
inline Declaration of(Claims claims, PointsAt points = PointsAt::clip) {
  Declaration declaration;
  declaration.name = "mistaken";
  declaration.scalar = ScalarType::float64;
  declaration.claims = claims;
  declaration.clips = false;
  declaration.points = points;
  return declaration;
}

inline Vector2<double> turned(const Vector2<double>& v, double angle) {
  return rotate<double>({std::cos(angle), std::sin(angle)}, v);
}

/// Cases of these regimes that overlap clearly, with a contact whose points bear the least depth
/// out.
template <class Check>
void for_overlapping(std::span<const Regime> among, std::optional<float> radius,
                     const Check& check) {
  for (const Regime& regime : among) {
    for (std::uint64_t i = 0; i < 60; ++i) {
      const PairCase pair = generate(47, regime, i, {.corpus = {}, .radius = radius});
      const Right right(pair);
      Declaration wide = of(Claims::separation);
      wide.scalar = ScalarType::float32;
      if (is_ill_posed(right.truth->size(), bounds(pair, wide, right.truth->extent()))) continue;
      if (!right.overlaps(wide) || right.manifold.count == 0) continue;
      std::string line;
      append_case_line(line, pair);
      INFO(regime.name << ", index " << i << "\n" << line);
      check(right);
    }
  }
}

}  // namespace manifuzz::mistakes
