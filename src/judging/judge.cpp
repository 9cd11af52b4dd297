#include "judging/judge.hpp"

#include <algorithm>

#include "judging/by_curve.hpp"
#include "judging/errors/clip_error.hpp"
#include "judging/unjudged.hpp"
#include "judging/used_shapes.hpp"

namespace manifuzz {
namespace {

/// A normal is the reference face's: no other tie has to do with it. A boundary within bound
/// excuses a difference of two right manifolds; what is wrong lies beyond every bound, whatever
/// boundary is near.
TieClass relevant(TieClass tie_class, Verdict verdict, bool is_of_face) {
  if (is_of_face && tie_class != TieClass::reference) return TieClass::none;
  const bool boundary =
      tie_class == TieClass::contact_boundary || tie_class == TieClass::clip_boundary;
  return boundary && verdict != Verdict::tie ? TieClass::none : tie_class;
}

Manifold<double> manifold_of(const Answer& answer, const Admissible& right) {
  if (const auto* const partial = std::get_if<PartialManifold>(&answer)) {
    return completed(*partial, right);
  }
  return std::get<Manifold<double>>(answer);
}

/// One collider's answer, what is right for it, and how it falls short.
struct Judged {
  Admissible right;
  Manifold<double> manifold;  ///< without places of one that claims less
  Mismatch mismatch;
  AnswerError error;       ///< how wrong it is
  Kind kind = Kind::none;  ///< in what
  bool by_curve = false;
  bool touches = false;
  bool is_unjudged = false;      ///< what it used is no pair of polygons to judge by
  bool is_altered = false;       ///< it used other shapes than the case's
  bool is_by_tolerance = false;  ///< right, but only by the tolerance that it declares

  bool is_wrong() const { return kind != Kind::none; }
  /// Whether its normal is none of the right faces' ones.
  bool is_of_face() const {
    return mismatch.kind == Kind::normal || mismatch.kind == Kind::reversed;
  }
};

void measure_clip(const exact::Truth& truth, const ColliderAnswer& given, Judged& clip) {
  if (clip.mismatch.kind == Kind::none) return;
  clip.error = clip_error(clip.manifold, clip.right);
  clip.kind = kind_of_clip(clip.error, clip.manifold, clip.right);
  if (clip.mismatch.kind != Kind::normal || !is_reversed(truth, given)) return;
  clip.mismatch.kind = clip.kind = Kind::reversed;
}

Judged judged_on(const std::shared_ptr<const exact::Truth>& truth, const ColliderAnswer& given) {
  Judged result;
  result.right = admissible(truth, given.declaration);
  result.by_curve = is_judged_by_curve(given.declaration, truth->pair());
  if (result.by_curve) {
    const CurveJudgement curve = judge_by_curve(*truth, given.declaration, given.answer);
    const auto said = said_along(given.answer);
    if (said && touches(given.answer)) {
      result.manifold.count = 1;
      result.manifold.normal = said->normal;
      result.manifold.points[0].depth = said->depth;
    }
    if (const auto* const manifold = manifold_in(given.answer)) result.manifold = *manifold;
    result.mismatch = {curve.kind, curve.magnitude, curve.bound};
    result.kind = curve.kind;
    if (result.is_wrong()) {
      result.error = curve_error(*truth, given.declaration, given.answer, curve);
    }
    result.touches = touches(given.answer);
    result.is_by_tolerance = curve.is_by_tolerance;
    return result;
  }
  result.manifold = manifold_of(given.answer, result.right);
  result.mismatch = mismatch(result.manifold, result.right);
  result.touches = result.manifold.count > 0;
  if (result.mismatch.kind == Kind::count && given.declaration.one_point_enough &&
      result.manifold.count == 1) {
    result.mismatch = {};
  }
  measure_clip(*truth, given, result);
  return result;
}

/// By the shapes that it used; that they are others is a finding where nothing else is one.
Judged judged(const std::shared_ptr<const exact::Truth>& truth, const ColliderAnswer& given) {
  const auto altered = altered_by(*truth, given);
  if (!altered) return judged_on(truth, given);
  Judged result;
  if (altered->truth) {
    result = judged_on(altered->truth, given);
  } else {
    result.right = admissible(truth, given.declaration);
    result.touches = touches(given.answer);
    result.is_unjudged = true;
  }
  result.is_altered = true;
  if (!result.is_wrong() && altered->is_beyond_rounding && !given.declaration.alters_shapes) {
    result.by_curve = true;
    result.mismatch = {Kind::altered_shape, altered->distance, altered->bound};
    result.kind = Kind::altered_shape;
    result.error.add_beyond(Component::position, altered->distance / truth->size(),
                            altered->bound / truth->size());
  }
  return result;
}

/// The ledger's cause of an answer that is lost or nonsense.
const LedgerEntry* explanation_of_lost(const PairCase& pair, const ColliderAnswer& given) {
  const auto* const lost = std::get_if<Lost>(&given.answer);
  const Lost::How how = lost != nullptr ? lost->how : Lost::How::malformed;
  return find_explanation(given.declaration.name, LostAnswer{pair, given.answer, how});
}

/// The ledger's cause of a wrong answer.
const LedgerEntry* explanation_of_wrong(const PairCase& pair, const ColliderAnswer& given,
                                        const Judged& wrong) {
  return find_explanation(given.declaration.name,
                          {wrong.right, wrong.manifold, wrong.mismatch.kind, &pair});
}

/// Whether two right answers say the same, as far as both say it of the same shapes.
bool agree(const Judged& subject, const Judged& oracle) {
  if (subject.is_altered || oracle.is_altered) return true;
  if (subject.by_curve || oracle.by_curve) return subject.touches == oracle.touches;
  return agree_within_bounds(subject.manifold, subject.right, oracle.manifold, oracle.right);
}

Fault fault_of(const Judged& subject, const Judged& oracle) {
  const bool of_subject = subject.is_wrong();
  const bool of_oracle = oracle.is_wrong();
  if (of_subject && of_oracle) return Fault::both;
  return of_subject ? Fault::subject : of_oracle ? Fault::oracle : Fault::none;
}

Verdict verdict_of(Fault fault) {
  constexpr std::array verdicts{Verdict::tie, Verdict::subject_wrong, Verdict::oracle_wrong,
                                Verdict::both_wrong};
  return verdicts[static_cast<std::size_t>(fault)];
}

/// How two right manifolds differ, or else how a wrong one falls short, the subject's before the
/// oracle's; the magnitude as a share of the size.
Mismatch disagreement(const Judged& subject, const Judged& oracle, double size) {
  if (!subject.is_wrong() && !oracle.is_wrong()) {
    if (subject.by_curve || oracle.by_curve) {
      return {subject.touches ? Kind::phantom_contact : Kind::missed_contact,
              subject.right.from_contact() / size};
    }
    const Mismatch apart =
        difference(subject.manifold, oracle.manifold, subject.right.from_contact());
    return {apart.kind, apart.magnitude / size};
  }
  const Judged& wrong = subject.is_wrong() ? subject : oracle;
  return {wrong.kind, wrong.error.magnitude, wrong.error.bound};
}

/// How many points a manifold has less than any right one must have; below zero, more than any has.
int points_missing(const Judged& judged) {
  if (judged.by_curve || !judged.is_wrong() || judged.right.candidates.empty()) return 0;
  int least = 2;
  int most = 0;
  for (const exact::Clip* const clip : judged.right.candidates) {
    const auto points = points_of(*clip);
    const auto needed = std::ranges::count_if(
        points, [&](const auto& point) { return !is_optional(judged.right, *clip, point); });
    least = std::min(least, static_cast<int>(needed));
    most = std::max(most, static_cast<int>(points.size()));
  }
  const int count = judged.manifold.count;
  return std::max(least - count, 0) + std::min(most - count, 0);
}

}  // namespace

const AnswerError& error_of(const Judgement& judgement) {
  return judgement.bucket.fault == Fault::oracle ? judgement.of_oracle : judgement.of_subject;
}

double error_of_kind(const Judgement& judgement) {
  const double of_kind = error_of(judgement).errors[component_of(judgement.bucket.kind)];
  return of_kind > 0 ? of_kind : judgement.magnitude;
}

WorstError worst_error(const Judgement& judgement) {
  return {judgement.magnitude, error_of(judgement).errors};
}

bool is_alike(const Judgement& judgement, const Judgement& root) {
  const bool is_within = judgement.magnitude <= judgement.bound;
  const bool is_root_within = root.magnitude <= root.bound;
  const bool are_about =
      is_within == is_root_within && (is_within || is_about(judgement.magnitude, root.magnitude));
  return judgement.bucket == root.bucket && judgement.explanation == root.explanation &&
         judgement.points_missing == root.points_missing && are_about;
}

Judgement judge(const std::shared_ptr<const exact::Truth>& truth, const ColliderAnswer& subject,
                const ColliderAnswer& oracle) {
  if (const auto bucket = without_judging(*truth, subject, oracle)) {
    Judgement result{.bucket = *bucket};
    if (!is_of_lost(*bucket) || bucket->fault != Fault::oracle) return result;
    const bool is_judgeable = !std::holds_alternative<Unsupported>(subject.answer);
    if (!is_judgeable || judged(truth, subject).is_wrong()) return result;
    result.explanation = explanation_of_lost(truth->pair(), oracle);
    if (result.explanation != nullptr) result.bucket.verdict = Verdict::known;
    return result;
  }
  const Judged of_subject = judged(truth, subject);
  const Judged of_oracle = judged(truth, oracle);
  Judgement result{.is_judged = true,
                   .of_subject = of_subject.error,
                   .of_oracle = of_oracle.error,
                   .is_by_tolerance = of_subject.is_by_tolerance || of_oracle.is_by_tolerance};
  Bucket& bucket = result.bucket;
  if (truth->has_faces()) bucket.reference = truth->greatest().side;
  bucket.fault = fault_of(of_subject, of_oracle);
  const bool is_unjudged = of_subject.is_unjudged || of_oracle.is_unjudged;
  if (bucket.fault == Fault::none && (is_unjudged || hides_all(*truth, subject, oracle))) {
    return {.bucket = {.verdict = Verdict::ill_posed}};
  }
  if (bucket.fault == Fault::none && agree(of_subject, of_oracle)) return result;
  const Mismatch found = disagreement(of_subject, of_oracle, truth->size());
  bucket.verdict = verdict_of(bucket.fault);
  bucket.kind = found.kind;
  const bool is_one_truth = of_subject.right.truth == of_oracle.right.truth;
  const TieClass tie = is_one_truth ? tie_class(of_subject.right, of_oracle.right) : TieClass::none;
  const Judged& wrong = of_subject.is_wrong() ? of_subject : of_oracle;
  const bool is_of_face = wrong.is_wrong() ? wrong.is_of_face() : bucket.kind == Kind::normal;
  bucket.tie_class = relevant(tie, bucket.verdict, is_of_face);
  result.magnitude = found.magnitude;
  result.bound = found.bound;
  if (bucket.fault != Fault::none) {
    bucket.error_class = class_of(found.kind, found.magnitude, found.bound);
  }
  result.points_missing = points_missing(wrong);
  if (bucket.verdict == Verdict::oracle_wrong) {
    result.explanation = explanation_of_wrong(truth->pair(), oracle, of_oracle);
    if (result.explanation != nullptr) bucket.verdict = Verdict::known;
  }
  return result;
}

Judgement judge_alone(const std::shared_ptr<const exact::Truth>& truth,
                      const ColliderAnswer& given) {
  return judge(truth, given, given);
}

void explain_subject(const std::shared_ptr<const exact::Truth>& truth,
                     const ColliderAnswer& subject, Judgement& judgement) {
  Bucket& bucket = judgement.bucket;
  if (bucket.fault != Fault::subject || !is_failure(bucket)) return;
  judgement.explanation =
      is_of_lost(bucket) ? explanation_of_lost(truth->pair(), subject)
                         : explanation_of_wrong(truth->pair(), subject, judged(truth, subject));
  if (judgement.explanation != nullptr) bucket.verdict = Verdict::known;
}

Judgement judge(const PairCase& pair, const ColliderAnswer& subject, const ColliderAnswer& oracle) {
  return judge(std::make_shared<const exact::Truth>(pair), subject, oracle);
}

Judgement judge(const PairCase& pair, const Collider& subject, const Collider& oracle) {
  const Answer of_subject = subject.collide(pair);
  const Answer of_oracle = oracle.collide(pair);
  return judge(pair, {subject.declaration, of_subject}, {oracle.declaration, of_oracle});
}

}  // namespace manifuzz
