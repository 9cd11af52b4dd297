#include "hunting/observation.hpp"

#include <algorithm>

#include "judging/bound_shares.hpp"
#include "judging/unjudged.hpp"

namespace manifuzz {
namespace {

bool is_subjects(const Bucket& bucket) {
  return bucket.fault == Fault::subject || bucket.fault == Fault::both;
}

void add_error(const Judgement& judgement, Observation& observed) {
  const AnswerError& error = judgement.of_subject;
  observed[Gauge::error] = error.magnitude;
  observed[Gauge::missed] = error.errors[Component::missing];
}

/// Bins of lead and margin are decades, the lower the smaller.
double nearness_of(const Conditions& conditions) {
  double near = 0;
  for (const Condition of :
       {Condition::lead_in_side, Condition::lead_of_side, Condition::slab_margin}) {
    near += kBins - 1 - conditions[of];
  }
  return near / (3 * kBins);
}

/// The greater share of a depth's bound and a position's.
double share_of_figures(const Observation& observed) {
  return std::max(observed[Gauge::position_share], observed[Gauge::depth_share]);
}

/// The greatest share of all three bounds.
double greatest_share(const Observation& observed) {
  return std::max(share_of_figures(observed), observed[Gauge::normal_share]);
}

/// The share that leads while no answer is wrong. A normal's counts in answers held against clips,
/// which a position's share tells: when it led in answers judged by the curve, hunts took longer
/// to meet rare bugs of round shapes.
double leading_share(const Observation& observed) {
  const bool is_held_against_clips = observed[Gauge::position_share] > 0;
  return is_held_against_clips ? greatest_share(observed) : share_of_figures(observed);
}

}  // namespace

Measure measure_of(Gauge gauge) {
  if (gauge == Gauge::error) return Measure::error;
  return gauge == Gauge::missed ? Measure::missed : Measure::bound_share;
}

Observation conditions_observed(const exact::Truth& truth, const Declaration& declaration) {
  Observation observed{.is_there = true};
  const Bounds bounds = manifuzz::bounds(truth.pair(), declaration, truth.extent());
  observed.is_well_posed = !is_ill_posed(truth.size(), bounds);
  if (!observed.is_well_posed) return observed;
  observed.conditions = conditions_of(truth);
  observed.nearness = nearness_of(observed.conditions);
  return observed;
}

Observation observation_of(const JudgedPair& judged) {
  Observation observed = conditions_observed(*judged.truth, judged.subject.declaration);
  if (!observed.is_well_posed) return observed;
  const Bucket& bucket = judged.judgement.bucket;
  if (is_subjects(bucket)) {
    add_error(judged.judgement, observed);
  } else if (!is_of_lost(bucket) && used_by(judged.subject.answer) == nullptr) {
    observed.gauges = shares_observed(judged.truth, judged.subject).gauges;
  }
  return observed;
}

Observation shares_observed(const std::shared_ptr<const exact::Truth>& truth,
                            const ColliderAnswer& given) {
  Observation observed;
  if (is_judged_by_curve(given.declaration, truth->pair())) {
    const ManifoldError shares = curve_shares(*truth, given);
    observed[Gauge::normal_share] = shares.normal;
    observed[Gauge::depth_share] = shares.depth;
    return observed;
  }
  const Admissible right = admissible(truth, given.declaration);
  const Answer answer = whole(given.answer, right, given.declaration);
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr) return observed;
  const ManifoldError shares = clip_shares(*manifold, right);
  observed[Gauge::normal_share] = shares.normal;
  observed[Gauge::position_share] = shares.position;
  observed[Gauge::depth_share] = shares.depth;
  return observed;
}

double value_of(const Observation& observed, const std::optional<Measure>& measure) {
  const double missed = observed[Gauge::missed];
  const double error = observed[Gauge::error];
  if (measure == Measure::bound_share) return greatest_share(observed);
  if (measure == Measure::missed) return missed > 0 ? 1 + missed : observed.nearness;
  return error > 0 ? 1 + error : leading_share(observed);
}

Aim aim_at(const std::optional<Measure>& measure) {
  Aim aim{.seeks =
              [measure](std::size_t gauge) {
                return !measure || measure_of(static_cast<Gauge>(gauge)) == *measure;
              },
          .value = [measure](const Observation& observed) { return value_of(observed, measure); }};
  // Who names a measure wants its greatest more than new cells.
  if (measure) aim.bred_from_greatest = 0.6;
  return aim;
}

}  // namespace manifuzz
