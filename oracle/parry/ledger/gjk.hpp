#pragma once

#include <tuple>

#include "oracle/parry/ledger/simplex.hpp"

namespace manifuzz::parry {

/// How gjk.rs, closest_points, ended.
enum class GjkEnd {
  on_simplex,          ///< dist <= _eps_tol: the origin is on the simplex
  stalled_apart,       ///< max_bound >= old_max_bound, best_min_bound > 0
  stalled_touching,    ///< the same, best_min_bound >= -_eps_rel * support_scale
  stalled_inside,      ///< the same, neither, and nothing found by perturbations
  out_of_reach,        ///< min_bound > max_dist
  near_enough,         ///< max_bound - min_bound <= _eps_rel * max_bound
  refused_apart,       ///< add_point refuses, best_min_bound > 0
  refused_touching,    ///< the same, best_min_bound >= -_eps_rel * support_scale
  refused_inside,      ///< the same, neither, and no perturbation is left
  full_apart,          ///< a triangle, min_bound >= _eps_tol
  inside,              ///< a triangle with the origin inside
  too_many_iterations  ///< 100
};

/// Places on both shapes, and the direction between them.
template <class Real>
struct GjkPlaces {
  Vector2<Real> on_a{0, 0};
  Vector2<Real> on_b{0, 0};
  Vector2<Real> direction{0, 0};
};

/// Where it has a corner already to which its direction leads, or comes no nearer: the origin's
/// place on its chord, from which the direction comes.
template <class Real>
struct GjkFoot {
  Vector2<Real> foot{0, 0};
  std::array<Vector2<Real>, 2> chord{};
};

/// What it found: places, where it found them.
template <class Real>
struct GjkResult : GjkPlaces<Real> {
  GjkEnd end = GjkEnd::inside;
  bool is_intersection = false;
  bool has_points = false;
  std::optional<GjkPlaces<Real>> after{};  ///< stalled_apart: of the step that it goes back from
  std::optional<GjkFoot<Real>> foot{};     ///< refused a corner of its chord, or stalled_apart
  bool is_refused = false;  ///< add_point took two corners for one that are not at one place
};

template <class Real>
class Gjk {
 public:
  /// Mended, if so asked: the origin's place on a chord is that of products without roundings, and
  /// shapes that are apart do not stall where it comes no nearer.
  Gjk(const Operands<Real>& operands, Real farthest, Simplex<Real>& simplex,
      bool is_foot_unrounded = false)
      : operands_(operands),
        farthest_(farthest),
        simplex_(simplex),
        is_foot_unrounded_(is_foot_unrounded) {}

  GjkResult<Real> run() {
    const Vector2<Real> first = simplex_.nearest_to_origin();
    const auto towards = try_normalize(first);
    if (!towards) return intersection(GjkEnd::on_simplex);
    old_direction_ = -*towards;
    nearest_ = first;
    for (;;) {
      if (const auto found = step()) return *found;
    }
  }

 private:
  using Found = std::optional<GjkResult<Real>>;

  Found step() {
    const Real old_most = most_;
    const auto [direction, distance] = normalize_and_length(Vector2<Real>(-nearest_));
    if (!(distance > kGjkTolerance<Real>)) return intersection(GjkEnd::on_simplex);
    direction_ = direction;
    most_ = distance;
    const bool goes_on = is_foot_unrounded_ && best_least_ > 0;
    if (most_ >= old_most && !goes_on) {
      if (best_least_ > 0) return on_chord(points(GjkEnd::stalled_apart, true, old_direction_));
      if (is_touching()) return points(GjkEnd::stalled_touching, true, old_direction_);
      if (perturbation_count_ == kPerturbationsMax) return intersection(GjkEnd::stalled_inside);
      direction_ = perturbed(direction_, ++perturbation_count_);
    }
    const Corner<Real> corner = corner_along(operands_, direction_);
    const Real least = -direction_.dot(corner.point);
    best_least_ = std::max(best_least_, least);
    scale_ = std::max(scale_, length_of(corner.point));
    if (least > farthest_) return ended(GjkEnd::out_of_reach);
    if (most_ - least <= relative_tolerance<Real>() * most_) {
      return points(GjkEnd::near_enough, false, direction_);
    }
    if (!simplex_.add(corner)) return refused();
    old_direction_ = direction_;
    nearest_ = nearest();
    if (simplex_.count() == 3) {
      if (least >= kGjkTolerance<Real>) return points(GjkEnd::full_apart, true, old_direction_);
      return intersection(GjkEnd::inside);
    }
    if (++iterations_ == 100) return ended(GjkEnd::too_many_iterations);
    return std::nullopt;
  }

  Vector2<Real> nearest() {
    const Vector2<Real> place = simplex_.nearest_to_origin();
    if (!is_foot_unrounded_ || simplex_.count() != 2) return place;
    return unrounded_foot(simplex_.corner(0).point, simplex_.corner(1).point);
  }

  Found refused() {
    is_refused_ = is_refused_ || simplex_.refused() > 0;
    if (best_least_ > 0) return on_chord(points(GjkEnd::refused_apart, false, direction_));
    if (is_touching()) return points(GjkEnd::refused_touching, false, direction_);
    if (perturbation_count_ == kPerturbationsMax) {
      return on_chord(intersection(GjkEnd::refused_inside));
    }
    return std::nullopt;
  }

  GjkResult<Real> on_chord(GjkResult<Real> result) const {
    if (simplex_.count() == 2 && simplex_.refused() == 0) {
      result.foot = {nearest_, {simplex_.corner(0).point, simplex_.corner(1).point}};
    }
    return result;
  }

  static constexpr int kPerturbationsMax = 4;

  static Vector2<Real> perturbed(const Vector2<Real>& direction, int seed) {
    Vector2<Real> moved = direction;
    const Real offset = ((seed - 1) / 2) % 2 == 0 ? Real(1.0e-2) : -Real(1.0e-2);
    ((seed - 1) % 2 == 0 ? moved.x() : moved.y()) += offset;
    return try_normalize(moved).value_or(direction);
  }
  bool is_touching() const { return best_least_ >= -relative_tolerance<Real>() * scale_; }

  GjkResult<Real> ended(GjkEnd end) const {
    GjkResult<Real> result;
    result.end = end;
    result.is_refused = is_refused_;
    return result;
  }
  GjkResult<Real> intersection(GjkEnd end) const {
    GjkResult<Real> result = ended(end);
    result.is_intersection = true;
    return result;
  }
  GjkResult<Real> points(GjkEnd end, bool is_previous, const Vector2<Real>& direction) const {
    GjkResult<Real> result = ended(end);
    result.has_points = true;
    std::tie(result.on_a, result.on_b) = simplex_.nearest(is_previous);
    result.direction = direction;
    if (end != GjkEnd::stalled_apart) return result;
    result.after.emplace();
    std::tie(result.after->on_a, result.after->on_b) = simplex_.nearest(false);
    result.after->direction = direction_;
    return result;
  }

  const Operands<Real>& operands_;
  Real farthest_;
  Simplex<Real>& simplex_;
  bool is_foot_unrounded_;
  Vector2<Real> nearest_{0, 0};
  Vector2<Real> direction_{0, 0};
  Vector2<Real> old_direction_{0, 0};
  Real most_ = std::numeric_limits<Real>::max();
  Real best_least_ = -std::numeric_limits<Real>::max();
  Real scale_ = 0;
  int perturbation_count_ = 0;
  int iterations_ = 0;
  bool is_refused_ = false;
};

}  // namespace manifuzz::parry
