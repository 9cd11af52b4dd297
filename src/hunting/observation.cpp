#include "hunting/observation.hpp"

#include <algorithm>
#include <cmath>

#include "judging/by_curve.hpp"
#include "judging/manifold_error.hpp"
#include "judging/unjudged.hpp"

namespace manifuzz {
namespace {

bool is_subjects(const Bucket& bucket) {
  return bucket.fault == Fault::subject || bucket.fault == Fault::both;
}

/// Adds the share of its bound by which a right answer's depth is off the least one, where the
/// penetration curve judges it. A collider that declares a tolerance or a tie bias has none: its
/// answers may be off by more than bounds.
void add_curve_share(const JudgedPair& judged, Observation& observed) {
  const exact::Truth& truth = *judged.truth;
  const Declaration& declaration = judged.subject.declaration;
  const auto said = said_along(judged.subject.answer);
  const bool is_held_to_bounds = declaration.tie_bias.is_none() && declaration.tolerance.is_none();
  if (!said || !touches(judged.subject.answer) || !is_held_to_bounds) return;
  const CurveBounds bounds = curve_bounds(truth.pair(), declaration, truth.extent());
  const exact::PenetrationCurve curve(truth, exact::skin_of(truth));
  observed[Gauge::depth_share] = std::abs(said->depth - curve.least()) / bounds.minimality;
}

/// Adds the shares of the bounds that a right answer's manifold takes, against the right one of
/// whose bounds it takes the least.
void add_clip_shares(const JudgedPair& judged, Observation& observed) {
  const Declaration& declaration = judged.subject.declaration;
  const Admissible right = admissible(judged.truth, declaration);
  const Answer answer = whole(judged.subject.answer, right, declaration);
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr || manifold->count == 0) return;
  ClipFiguresCache figures;
  const auto nearest = error_if_right(*manifold, right, figures);
  if (!nearest) return;
  observed[Gauge::normal_share] = nearest->of_bound.normal;
  observed[Gauge::position_share] = nearest->of_bound.position;
  observed[Gauge::depth_share] = nearest->of_bound.depth;
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

}  // namespace

Measure measure_of(Gauge gauge) {
  if (gauge == Gauge::error) return Measure::error;
  return gauge == Gauge::missed ? Measure::missed : Measure::bound_share;
}

Observation observation_of(const JudgedPair& judged) {
  const exact::Truth& truth = *judged.truth;
  Observation observed{.is_there = true};
  const Bounds bounds = manifuzz::bounds(truth.pair(), judged.subject.declaration, truth.extent());
  observed.is_well_posed = !is_ill_posed(truth.size(), bounds);
  if (!observed.is_well_posed) return observed;
  observed.conditions = conditions_of(truth);
  observed.nearness = nearness_of(observed.conditions);
  const Bucket& bucket = judged.judgement.bucket;
  if (is_subjects(bucket)) {
    add_error(judged.judgement, observed);
  } else if (!is_of_lost(bucket) && used_by(judged.subject.answer) == nullptr) {
    const bool by_curve = is_judged_by_curve(judged.subject.declaration, truth.pair());
    by_curve ? add_curve_share(judged, observed) : add_clip_shares(judged, observed);
  }
  return observed;
}

double value_of(const Observation& observed, const std::optional<Measure>& measure) {
  const double share = std::max({observed[Gauge::normal_share], observed[Gauge::position_share],
                                 observed[Gauge::depth_share]});
  const double missed = observed[Gauge::missed];
  const double error = observed[Gauge::error];
  if (measure == Measure::bound_share) return share;
  if (measure == Measure::missed) return missed > 0 ? 1 + missed : observed.nearness;
  return error > 0 ? 1 + error : share;
}

}  // namespace manifuzz
