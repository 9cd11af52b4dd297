#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exact/curve.hpp"
#include "judging/bounds.hpp"
#include "report/round_truth.hpp"
#include "report/upstream/effect.hpp"
#include "report/upstream/parts.hpp"

namespace manifuzz {

std::string plain(double value) {
  return fmt::format("{:.3g}", value + 0.0);
}

double depth_along(const PairCase& pair, const Said& claim) {
  if (!claim.normal || claim.normal->isZero(0)) return true_depth(pair);
  const exact::Truth truth(pair);
  return exact::Along(truth, *claim.normal).depth();
}

bool is_far_too_deep(const PairCase& pair, const Said& claim, const Declaration& declaration) {
  const double depth = true_depth(pair);
  return claim.depth > 2 * std::abs(depth) &&
         claim.depth - depth > 100 * bounds(pair, declaration).separation;
}

int right_count(const JudgedCase& judged, const Declaration& declaration) {
  int most = 0;
  for (const Manifold<double>& right :
       manifolds_to_show(admissible(judged.given.pair(), declaration), declaration)) {
    most = std::max(most, right.count);
  }
  return most;
}

bool is_nonsense(const DeclaredAnswer& asked) {
  const auto* const lost = std::get_if<Lost>(&asked.answer);
  return lost == nullptr || lost->how == Lost::How::malformed;
}

namespace {

/// A share of the smaller shape's size, or of a unit normal: so little is not seen, but checks fail
/// by it.
constexpr double kUnseen = 1e-3;

std::string with_share(const Sight& sight, double size) {
  if (!(sight.share < kUnseen)) return sight.text;
  const std::string against =
      sight.is_length ? fmt::format(" on a shape of size {}", plain(size)) : "";
  return fmt::format(
      "{}; that is too little to be visible{}, but exact comparisons fail, such as "
      "assertions or checks that two platforms agree",
      sight.text, against);
}

/// What is seen where points lie beside the right ones.
std::optional<Sight> seen_of_place(const JudgedCase& judged, const DeclaredAnswer& asked) {
  const PairCase& pair = judged.given.pair();
  constexpr std::string_view spin = "so the bodies get a spin that they should not have";
  if (told_kind(judged, asked) == Kind::position) {
    const double off = point_errors(pair, asked).place;
    return Sight{fmt::format("the impulse acts {} beside the right place, {}", plain(off), spin),
                 off / size(pair)};
  }
  const double outside = outside_by(pair, asked);
  if (outside > bounds(pair, asked.declaration).position) {
    return Sight{
        fmt::format("the impulse acts {} outside one of the bodies, {}", plain(outside), spin),
        outside / size(pair)};
  }
  return Sight{
      fmt::format("the impulse acts where the bodies are not as deep in each other as the "
                  "depth says, {}",
                  spin)};
}

/// What is seen where points are too many, too few or too close together.
std::optional<Sight> seen_of_count(const JudgedCase& judged, const DeclaredAnswer& asked) {
  const Said claim = said_by(asked.answer);
  if (points_in(claim) > right_count(judged, asked.declaration)) {
    return Sight{"a second contact point takes a part of the impulse where one point is right"};
  }
  const Manifold<double>* const given = manifold_in(asked.answer);
  const RightContact right = right_contact(judged.given.pair(), asked);
  if (given == nullptr || !right.manifold) return std::nullopt;
  const double full = span_of(*right.manifold);
  const double span = span_of(*given);
  const double share = std::abs(full - span) / size(judged.given.pair());
  if (points_in(claim) < 2) {
    return Sight{fmt::format("one contact point carries bodies that touch along {}, so they rock",
                             plain(full)),
                 share};
  }
  if (span > full) {
    return Sight{
        fmt::format("the contact points are {} apart where the bodies touch along {} only, "
                    "so a part of the impulse acts beside them",
                    plain(span), plain(full)),
        share};
  }
  return Sight{
      fmt::format("the contact points are {} apart where the bodies touch along {}, so they "
                  "rock",
                  plain(span), plain(full)),
      share};
}

/// What is seen where the deepest point and the normal are as they should be.
Sight seen_of_points(const JudgedCase& judged, const DeclaredAnswer& asked) {
  const PointErrors off = point_errors(judged.given.pair(), asked);
  if (off.depth > off.place && !asked.declaration.shares_depth) {
    return {fmt::format("one contact point's depth is off by {}, so the push turns the bodies",
                        plain(off.depth)),
            off.depth / size(judged.given.pair())};
  }
  return {fmt::format("the impulse acts {} beside the right place", plain(off.place)),
          off.place / size(judged.given.pair())};
}

/// What the kind of the finding says first; none where the push says it all.
std::optional<Sight> seen_of_kind(const JudgedCase& judged, const DeclaredAnswer& asked) {
  switch (told_kind(judged, asked)) {
    case Kind::position:
    case Kind::witness:
      return seen_of_place(judged, asked);
    case Kind::count:
    case Kind::extent:
      return seen_of_count(judged, asked);
    case Kind::features:
      return Sight{"impulses of the last step are not found again, so warm starting is lost"};
    case Kind::altered_shape:
      return Sight{"bodies collide as another shape than was given"};
    default:
      return std::nullopt;
  }
}

}  // namespace

std::string seen_by_users(const JudgedCase& judged, const DeclaredAnswer& asked) {
  if (judged.judgement.bucket.kind == Kind::none) {  // the answer was lost, or cannot be read
    return is_nonsense(asked)
               ? "figures that are no numbers, or no contact, spread through the simulation"
               : "the simulation stops";
  }
  const std::optional<Sight> of_kind = seen_of_kind(judged, asked);
  if (of_kind && of_kind->share >= kUnseen) return with_share(*of_kind, size(judged.given.pair()));
  Effect effect = effect_of(judged, asked);
  std::optional<Sight> of_push = seen_of_push(effect);
  if (!of_kind && !of_push) {  // what is wrong is within what the depth may be off by
    effect.rounding = effect.turn_rounding = 0;
    of_push = seen_of_push(effect);
  }
  if (of_push && (!of_kind || of_push->share >= kUnseen))
    return with_share(*of_push, size(judged.given.pair()));
  return with_share(of_kind ? *of_kind : seen_of_points(judged, asked), size(judged.given.pair()));
}

}  // namespace manifuzz
