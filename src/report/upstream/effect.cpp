#include "report/upstream/effect.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "exact/placed.hpp"
#include "judging/bounds.hpp"
#include "judging/by_curve.hpp"
#include "report/upstream/parts.hpp"

namespace manifuzz {
namespace {

/// A depth that is so small a share of the overlap pushes nothing apart.
constexpr double kNoPush = 1e-3;

/// How deep two bodies overlap along each direction, once B is moved.
class PushedPair {
 public:
  PushedPair(const PairCase& pair, const Vector2<double>& push)
      : pair_(pair), placed_(exact::place_roughly(pair)), push_(push) {}

  double overlap() {
    for (int i = 0; i < placed_.a.face_count(); ++i) consider(placed_.a.normals[i]);
    for (int i = 0; i < placed_.b.face_count(); ++i) consider(-placed_.b.normals[i]);
    if (is_round(pair_)) consider_corners();
    return least_;
  }

 private:
  /// Corners that are nearest decide where the cores are apart; elsewhere some face has less.
  void consider_corners() {
    for (int i = 0; i < placed_.a.count; ++i) {
      for (int k = 0; k < placed_.b.count; ++k) {
        const Vector2<double> between = placed_.b.vertices[k] + push_ - placed_.a.vertices[i];
        const double length = between.norm();
        consider(length > 0 ? Vector2<double>(between / length) : Vector2<double>(1, 0));
      }
    }
  }

  void consider(const Vector2<double>& unit) {
    double farthest_of_a = -INFINITY;
    double nearest_of_b = INFINITY;
    for (int i = 0; i < placed_.a.count; ++i) {
      farthest_of_a = std::max(farthest_of_a, unit.dot(placed_.a.vertices[i]));
    }
    for (int k = 0; k < placed_.b.count; ++k) {
      nearest_of_b = std::min(nearest_of_b, unit.dot(placed_.b.vertices[k] + push_));
    }
    least_ = std::min(least_, farthest_of_a - nearest_of_b + total_radius(pair_));
  }

  const PairCase& pair_;
  exact::RoughPair placed_;
  Vector2<double> push_;
  double least_ = INFINITY;
};

Sight seen_of_no_contact(const Effect& effect) {
  if (effect.overlap <= effect.rounding) {
    return {"bodies that touch have no contact, so nothing holds them apart"};
  }
  return {
      fmt::format("nothing pushes the bodies apart: they stay {} inside each other, or move "
                  "further in",
                  plain(effect.overlap))};
}

Sight seen_across_gap(const Effect& effect) {
  const double gap = -effect.overlap;
  const std::string bodies = fmt::format("bodies that are {} apart are ", plain(gap));
  if (effect.push <= effect.rounding) {
    return {bodies + "stopped as if they touched", gap / effect.size};
  }
  const bool is_towards = effect.overlap_after > effect.overlap;
  return {fmt::format("{}pushed by {}, {} each other", bodies, plain(effect.push),
                      is_towards ? "towards" : "away from"),
          std::max(gap, effect.push) / effect.size};
}

/// What is seen where bodies are still inside each other.
Sight seen_inside(const Effect& effect, double before) {
  const std::string left = plain(effect.overlap_after);
  const double share = effect.overlap_after / effect.size;
  if (effect.push <= kNoPush * before) {
    return {
        fmt::format("a depth of {} pushes nothing apart: the bodies stay {} inside each other, "
                    "or move further in",
                    plain(effect.push), left)};
  }
  if (effect.turn > effect.turn_rounding && angle_in_words(effect.turn).ends_with("degrees")) {
    return {fmt::format("the bodies are pushed by {} along a direction that is off by {}, and stay "
                        "{} inside each other",
                        plain(effect.push), angle_in_words(effect.turn), left),
            share};
  }
  if (plain(effect.push) == plain(before)) {
    return {fmt::format("the bodies stay {} inside each other", left), share};
  }
  return {fmt::format("the bodies are pushed by {} where {} is needed, and stay {} inside each "
                      "other",
                      plain(effect.push), plain(before), left),
          share};
}

Sight seen_too_far(const Effect& effect, double enough) {
  const double more = effect.push - enough;
  const double share = more / effect.size;
  if (plain(effect.push) == plain(enough)) {
    return {fmt::format("the bodies are pushed {} farther than they need", plain(more)), share};
  }
  return {fmt::format("the bodies are pushed by {} where {} suffices", plain(effect.push),
                      plain(enough)),
          share};
}

/// What a push does that is as long as it should be.
std::optional<Sight> seen_of_normal(const Effect& effect) {
  if (effect.turn > std::numbers::pi / 2) {
    return Sight{"the normal points the wrong way, so impulses drive the bodies into each other"};
  }
  if (effect.turn > effect.turn_rounding) {
    std::string text =
        "impulses act along a direction that is off by " + angle_in_words(effect.turn);
    const double enough = std::max(effect.overlap, 0.0);
    if (plain(effect.push) != plain(enough)) {
      text += fmt::format(", with a depth of {} where the bodies overlap by {}", plain(effect.push),
                          plain(enough));
    }
    return Sight{text, effect.turn, false};
  }
  const double lacking = std::abs(1 - effect.length);
  if (lacking <= effect.turn_rounding) return std::nullopt;
  if (lacking < 1e-3) {
    return Sight{
        fmt::format("a push along the normal is {} by {} of itself, as the normal's length "
                    "is off by that from 1",
                    effect.length > 1 ? "too long" : "too short", plain(lacking)),
        lacking, false};
  }
  return Sight{fmt::format("what takes the normal for one of length 1 pushes too {} by a factor of "
                           "{}",
                           effect.length > 1 ? "far," : "little,", short_figure(effect.length)),
               lacking, false};
}

}  // namespace

double overlap_once_pushed(const PairCase& pair, const Vector2<double>& push) {
  return PushedPair(pair, push).overlap();
}

Effect effect_of(const JudgedCase& judged, const DeclaredAnswer& asked) {
  const PairCase& pair = judged.given.pair();
  const Said claim = said_by(asked.answer);
  const Bounds within = bounds(pair, asked.declaration);
  Effect effect{.is_contact = claim.touches,
                .size = size(pair),
                .overlap = true_depth(pair),
                .push = claim.depth,
                .overlap_after = true_depth(pair),
                .rounding = within.separation,
                .turn_rounding = within.normal};
  if (is_judged_by_curve(asked.declaration, pair)) {
    const exact::Truth truth(pair);
    const CurveBounds curve = curve_bounds(pair, asked.declaration, truth.extent());
    effect.rounding = std::max({within.separation, curve.minimality, curve.consistency});
    effect.turn_rounding = std::max(within.normal, curve.normal);
  }
  if (!claim.touches || !claim.normal) return effect;
  effect.length = claim.normal->norm();
  if (effect.length == 0) return effect;
  const RightContact right = right_contact(pair, asked);
  if (right.manifold && right.manifold->count > 0 && !right.is_along_own) {
    effect.turn = exact::angle_between(right.manifold->normal, *claim.normal);
  }
  const Vector2<double> unit = world_normal(pair, *claim.normal / effect.length).normalized();
  if (claim.depth > 0) effect.overlap_after = overlap_once_pushed(pair, claim.depth * unit);
  return effect;
}

std::optional<Sight> seen_of_push(const Effect& effect) {
  const double before = std::max(effect.overlap, 0.0);
  if (!effect.is_contact) return seen_of_no_contact(effect);
  if (effect.overlap < -effect.rounding) return seen_across_gap(effect);
  if (effect.length == 0) {
    return Sight{
        "a normal of length 0 has no direction to push along, so the bodies stay inside "
        "each other"};
  }
  const double deeper = effect.overlap_after - before;
  if (deeper > effect.rounding) {
    return Sight{fmt::format("the bodies are pushed {} further into each other", plain(deeper)),
                 deeper / effect.size};
  }
  if (effect.overlap_after > effect.rounding) return seen_inside(effect, before);
  if (effect.push - before > effect.rounding) return seen_too_far(effect, before);
  return seen_of_normal(effect);
}

std::string angle_in_words(double radians) {
  const double degrees = radians * 180 / std::numbers::pi;
  return degrees >= 0.1 ? plain(degrees) + " degrees" : plain(radians) + " radians";
}

}  // namespace manifuzz
