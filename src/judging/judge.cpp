#include "judging/judge.hpp"

#include <algorithm>

#include "judging/by_curve.hpp"
#include "judging/tie_class.hpp"
#include "judging/used_shapes.hpp"

namespace manifuzz {
namespace {

/// Its magnitude is a difference of directions then, and no length.
bool is_of_normal(Kind kind) {
  return kind == Kind::normal || kind == Kind::reversed;
}

/// A normal is the reference face's: no other tie has to do with it. A boundary within bound
/// excuses a difference of two right manifolds; what is wrong lies beyond every bound, whatever
/// boundary is near.
TieClass relevant(TieClass tie_class, Verdict verdict, Kind kind) {
  if (is_of_normal(kind) && tie_class != TieClass::reference) return TieClass::none;
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

Verdict verdict_of(Lost::How how) {
  constexpr std::array verdicts{Verdict::crashed, Verdict::timed_out, Verdict::malformed};
  return verdicts[static_cast<std::size_t>(how)];
}

/// An answer that is no manifold to judge, as the finding that it is by itself: lost, or nonsense.
std::optional<Bucket> without_manifold(const PairCase& pair, const ColliderAnswer& given,
                                       Fault fault) {
  const Answer& answer = given.answer;
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    return bucket_of_lost(verdict_of(lost->how), fault);
  }
  if (!why_malformed(pair, given)) return std::nullopt;
  return bucket_of_lost(Verdict::malformed, fault);
}

/// A verdict that needs no judging of manifolds, if it is one.
std::optional<Bucket> without_judging(const exact::Truth& truth, const ColliderAnswer& subject,
                                      const ColliderAnswer& oracle) {
  const PairCase& pair = truth.pair();
  const auto is_tighter = [](const Bounds& a, const Bounds& b) {
    return a.separation < b.separation;
  };
  const Bounds wider = std::max({bounds(pair, subject.declaration, truth.extent()),
                                 bounds(pair, oracle.declaration, truth.extent())},
                                is_tighter);
  // What overflows in the collider's scalar is no nonsense of the collider's.
  if (!std::isfinite(wider.separation)) return Bucket{.verdict = Verdict::ill_posed};
  if (const auto bucket = without_manifold(pair, subject, Fault::subject)) return bucket;
  if (const auto bucket = without_manifold(pair, oracle, Fault::oracle)) return bucket;
  if (std::holds_alternative<Unsupported>(subject.answer) ||
      std::holds_alternative<Unsupported>(oracle.answer)) {
    return Bucket{.verdict = Verdict::unsupported};
  }
  if (is_ill_posed(truth.size(), wider) ||
      std::max(tolerance_of(truth, subject.declaration), tolerance_of(truth, oracle.declaration)) >
          kIllPosedShare * truth.size()) {
    return Bucket{.verdict = Verdict::ill_posed};
  }
  return std::nullopt;
}

/// One collider's answer, what is right for it, and how it falls short.
struct Judged {
  Admissible right;
  Manifold<double> manifold;  ///< without places of one that claims less
  Mismatch mismatch;
  bool by_curve = false;
  bool touches = false;
  bool is_unjudged = false;      ///< what it used is no pair of polygons to judge by
  bool is_altered = false;       ///< it used other shapes than the case's
  bool is_by_tolerance = false;  ///< right, but only by the tolerance that it declares

  bool is_wrong() const { return mismatch.kind != Kind::none; }
};

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
  if (result.mismatch.kind == Kind::normal && is_reversed(*truth, given)) {
    result.mismatch.kind = Kind::reversed;
  }
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
  }
  return result;
}

/// Why the oracle's answer is lost or nonsense, where the ledger says so and the subject is right.
const LedgerEntry* explanation_of_lost(const std::shared_ptr<const exact::Truth>& truth,
                                       const ColliderAnswer& subject,
                                       const ColliderAnswer& oracle) {
  if (std::holds_alternative<Unsupported>(subject.answer)) return nullptr;
  const auto* const lost = std::get_if<Lost>(&oracle.answer);
  const Lost::How how = lost != nullptr ? lost->how : Lost::How::malformed;
  const LedgerEntry* const entry =
      find_explanation(oracle.declaration.name, LostAnswer{truth->pair(), oracle.answer, how});
  return entry != nullptr && !judged(truth, subject).is_wrong() ? entry : nullptr;
}

/// Of answers that are both right: whether they say the same, as far as both say it of the same
/// shapes.
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

/// The error of a wrong manifold.
ManifoldError error_of(const Judged& judged) {
  if (!judged.is_wrong()) return {};
  if (judged.by_curve && is_of_normal(judged.mismatch.kind)) {
    return {.normal = judged.mismatch.magnitude};
  }
  if (judged.by_curve) return {.depth = judged.mismatch.magnitude / judged.right.truth->size()};
  return share_of_size(plain_error(judged.manifold, judged.right), judged.right.truth->size());
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
  const auto [kind, magnitude, bound] = subject.is_wrong() ? subject.mismatch : oracle.mismatch;
  if (is_of_normal(kind)) return {kind, magnitude, bound};
  return {kind, magnitude / size, bound / size};
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

bool is_alike(const Judgement& judgement, const Judgement& root) {
  const bool are_within_bounds =
      judgement.magnitude <= judgement.bound && root.magnitude <= root.bound;
  return judgement.bucket == root.bucket && judgement.explanation == root.explanation &&
         judgement.points_missing == root.points_missing &&
         (is_about(judgement.magnitude, root.magnitude) || are_within_bounds);
}

Judgement judge(const std::shared_ptr<const exact::Truth>& truth, const ColliderAnswer& subject,
                const ColliderAnswer& oracle) {
  if (const auto bucket = without_judging(*truth, subject, oracle)) {
    Judgement result{.bucket = *bucket};
    if (!is_of_lost(*bucket) || bucket->fault != Fault::oracle) return result;
    result.explanation = explanation_of_lost(truth, subject, oracle);
    if (result.explanation != nullptr) result.bucket.verdict = Verdict::known;
    return result;
  }
  const Judged of_subject = judged(truth, subject);
  const Judged of_oracle = judged(truth, oracle);
  Judgement result{.of_subject = error_of(of_subject),
                   .of_oracle = error_of(of_oracle),
                   .is_by_tolerance = of_subject.is_by_tolerance || of_oracle.is_by_tolerance};
  Bucket& bucket = result.bucket;
  if (truth->has_faces()) bucket.reference = truth->greatest().side;
  bucket.fault = fault_of(of_subject, of_oracle);
  if (bucket.fault == Fault::none && (of_subject.is_unjudged || of_oracle.is_unjudged)) {
    return {.bucket = {.verdict = Verdict::ill_posed}};
  }
  if (bucket.fault == Fault::none && agree(of_subject, of_oracle)) return result;
  const Mismatch found = disagreement(of_subject, of_oracle, truth->size());
  bucket.verdict = verdict_of(bucket.fault);
  bucket.kind = found.kind;
  const bool is_one_truth = of_subject.right.truth == of_oracle.right.truth;
  const TieClass tie = is_one_truth ? tie_class(of_subject.right, of_oracle.right) : TieClass::none;
  bucket.tie_class = relevant(tie, bucket.verdict, bucket.kind);
  result.magnitude = found.magnitude;
  result.bound = found.bound;
  if (bucket.fault != Fault::none) {
    bucket.error_class = class_of(found.kind, found.magnitude, found.bound);
  }
  result.points_missing = points_missing(of_subject.is_wrong() ? of_subject : of_oracle);
  if (bucket.verdict == Verdict::oracle_wrong) {
    result.explanation = find_explanation(
        oracle.declaration.name, {of_oracle.right, of_oracle.manifold, found.kind, &truth->pair()});
    if (result.explanation != nullptr) bucket.verdict = Verdict::known;
  }
  return result;
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
