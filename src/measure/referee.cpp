#include "measure/referee.hpp"

#include <algorithm>
#include <limits>

#include "judging/by_curve.hpp"
#include "judging/judge.hpp"
#include "judging/unjudged.hpp"

namespace manifuzz {
namespace {

bool is_gross(const ManifoldError& of_size) {
  return std::max({of_size.depth, of_size.position, of_size.normal}) > kGrossShare;
}

/// A collider's own bounds, as far as they are not owed to the distance from the origin.
Bounds limited(const Bounds& own, const Bounds& in_a_frame, double size) {
  const auto limit = [&](double Bounds::*figure, double gross) {
    return std::min(own.*figure, std::max(in_a_frame.*figure, gross));
  };
  return {.separation = limit(&Bounds::separation, kGrossShare * size),
          .incident_dot = limit(&Bounds::incident_dot, kGrossShare),
          .normal = limit(&Bounds::normal, kGrossShare),
          .position = limit(&Bounds::position, kGrossShare * size)};
}

/// Whether the manifold has a point of its own, within `reach`, for each that must be there, and
/// none besides. One may stand for two that are within bound of each other.
bool has_points_of(const exact::Clip& clip, const Manifold<double>& manifold,
                   const Admissible& right, double reach) {
  const auto has = [&](int k, int i) {
    const exact::ClipPoint& point = clip.points[k];
    if (is_optional(right, clip, point)) return true;
    return i < manifold.count &&
           (manifold.points[i].position - point.position()).stableNorm() <= reach;
  };
  if (manifold.count > clip.count) return false;
  if (clip.count == 1) return has(0, 0);
  const double bound = std::max(position_bound(right, clip, clip.points[0]),
                                position_bound(right, clip, clip.points[1]));
  if (compare_apart(clip, 2 * bound) <= 0) return has(0, 0) || has(1, 0);
  return (has(0, 0) && has(1, 1)) || (has(0, 1) && has(1, 0));
}

}  // namespace

Referee::Rules& Referee::rules_for(const Declaration& declaration) {
  for (const auto& rules : rules_) {
    if (rules->scalar == declaration.scalar && rules->frame == declaration.frame &&
        rules->takes_angles == declaration.takes_angles &&
        rules->tie_bias == declaration.tie_bias) {
      return *rules;
    }
  }
  Declaration in_a_frame = declaration;
  in_a_frame.frame = RoundingFrame::local;
  const Bounds own = bounds(truth_->pair(), declaration, truth_->extent());
  const Bounds of_input = bounds(truth_->pair(), in_a_frame, truth_->extent());
  rules_.push_back(std::make_unique<Rules>(Rules{
      declaration.scalar, declaration.frame, declaration.takes_angles, declaration.tie_bias,
      admissible(truth_, declaration.tie_bias, limited(own, of_input, truth_->size())), of_input}));
  return *rules_.back();
}

const Admissible& Referee::right_for(const Declaration& declaration) {
  return rules_for(declaration).right;
}

Answer Referee::whole(const Declaration& declaration, Answer answer) {
  if (auto* const partial = std::get_if<PartialManifold>(&answer)) {
    partial->used.reset();  // it is measured by the case's shapes
    answer = manifuzz::whole(std::move(answer), rules_for(declaration).right, declaration);
  }
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr) return answer;
  const auto why = why_malformed(truth_->pair(), *manifold);
  return why ? Lost{Lost::How::malformed, *why} : answer;
}

Measured Referee::measure_by_curve(const Declaration& declaration, const Answer& answer) {
  const exact::PenetrationCurve curve(*truth_, exact::skin_of(*truth_));
  const double size = truth_->size();
  const double least = curve.least();
  const Rules& rules = rules_for(declaration);
  if (is_ill_posed(size, rules.in_a_frame)) return {.assessment = Assessment::ill_posed};
  Measured measured;
  if (const auto found = error_against(curve, *truth_, {declaration, answer})) {
    measured.has_errors = true;
    measured.error = found->error;
    measured.of_size = share_of_size(measured.error, size);
    measured.of_bound = found->of_bound;
    measured.of_extent = measured.error.depth / (roundoff(rules.scalar) * truth_->extent());
  }
  const Kind kind = judge_by_curve(*truth_, declaration, answer).kind;
  measured.assessment = kind == Kind::missed_contact    ? Assessment::missed
                        : kind == Kind::phantom_contact ? Assessment::phantom
                        : is_gross(measured.of_size)    ? Assessment::gross
                                                        : Assessment::right;
  if (is_wrong(measured.assessment)) {
    measured.wrongness = to_float(std::max(measured.of_size.depth, std::abs(least) / size));
  }
  return measured;
}

Measured Referee::measure(const Declaration& declaration, const Answer& answer) {
  if (std::holds_alternative<Unsupported>(answer)) return {.assessment = Assessment::unsupported};
  if (is_judged_by_curve(declaration, truth_->pair()) && !std::holds_alternative<Lost>(answer) &&
      !why_malformed(truth_->pair(), ColliderAnswer{declaration, answer})) {
    return measure_by_curve(declaration, answer);
  }
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr) {
    return {.assessment = Assessment::lost, .wrongness = std::numeric_limits<float>::max()};
  }
  Rules& rules = rules_for(declaration);
  const auto before =
      std::ranges::find(rules.measured, *manifold, &std::pair<Manifold<double>, Measured>::first);
  if (before != rules.measured.end()) return before->second;
  return rules.measured.emplace_back(*manifold, measure(rules, *manifold)).second;
}

const Manifold<double>& Referee::truth_for(const Declaration& declaration) {
  Rules& rules = rules_for(declaration);
  if (rules.truth) return *rules.truth;
  if (truth_->compare_contact(0) > 0) return rules.truth.emplace();
  const Side side = reference_under(*truth_, declaration.tie_bias);
  const exact::FaceOf face = truth_->greatest(side);
  const exact::Clip& clip = truth_->clip(face, truth_->incident_edges(face, 0).front());
  return rules.truth.emplace(true_manifold(clip));
}

bool Referee::has_right_count(const Admissible& right, const Manifold<double>& manifold) {
  const double reach = kGrossShare * truth_->size();
  return std::ranges::any_of(right.candidates, [&](const exact::Clip* clip) {
    if (!has_points_of(*clip, manifold, right, reach)) return false;
    const ManifoldError error = error_against(manifold, figures_.of(*clip), right.bounds).error;
    return !is_gross(share_of_size(error, truth_->size()));
  });
}

Measured Referee::measure(const Rules& rules, const Manifold<double>& manifold) {
  const Admissible& right = rules.right;
  const double size = truth_->size();
  Measured measured;
  const auto if_right = error_if_right(manifold, right, figures_);
  const auto nearest = if_right ? if_right : nearest_error(manifold, right, figures_);
  if (nearest) {
    measured.has_errors = true;
    measured.error = nearest->error;
    measured.of_size = share_of_size(nearest->error, size);
    measured.of_bound =
        rules.frame == RoundingFrame::local
            ? nearest->of_bound
            : error_against(manifold, figures_.of(*nearest->clip), rules.in_a_frame).of_bound;
    measured.of_extent = std::max(nearest->error.depth, nearest->error.position) /
                         (roundoff(rules.scalar) * truth_->extent());
  }
  measured.assessment = [&] {
    if (is_ill_posed(size, rules.in_a_frame)) return Assessment::ill_posed;
    if (manifold.count == 0) {
      const bool is_right = mismatch(manifold, right).kind == Kind::none;
      return is_right ? Assessment::right : Assessment::missed;
    }
    if (!right.may_touch) return Assessment::phantom;
    if (is_gross(measured.of_size)) return Assessment::gross;
    if (!if_right && !has_right_count(right, manifold)) return Assessment::wrong_count;
    return Assessment::right;
  }();
  if (measured.assessment == Assessment::missed || measured.assessment == Assessment::phantom) {
    measured.wrongness = to_float(right.from_contact() / size);
  } else if (is_wrong(measured.assessment)) {
    measured.wrongness = to_float(std::max(measured.of_size.depth, measured.of_size.position));
  }
  return measured;
}

Manifold<double> rounded_once(const Manifold<double>& truth) {
  auto rounded = manifold_cast<double>(manifold_cast<float>(truth));
  // A depth of nothing may be less than nothing by the double's last digit.
  for (auto& point : rounded.points) point.depth = std::max(point.depth, 0.0);
  return rounded;
}

}  // namespace manifuzz
