#include "judging/judge.hpp"

#include <algorithm>
#include <limits>

#include "base/random.hpp"
#include "generating/drafts.hpp"
#include "judging/by_curve.hpp"

namespace manifuzz {
namespace {

using exact::Clip;

bool several_references(const Admissible& right) {
  return std::ranges::any_of(right.candidates, [&](const Clip* clip) {
    return clip->reference != right.candidates.front()->reference;
  });
}

bool contact_boundary(const Admissible& right) {
  if (right.may_touch && right.may_be_apart) return true;
  const Clip& clip = *right.candidates.front();
  return std::ranges::any_of(
      points_of(clip), [&](const auto& point) { return is_at_zero_depth(right, clip, point); });
}

bool clip_boundary(const Admissible& right) {
  const Clip& clip = *right.candidates.front();
  return clip.count < 2 || may_miss(right, clip) ||
         std::ranges::any_of(points_of(clip), [&](const auto& point) {
           return compare_margin(clip, point.end, right.bounds.separation) <= 0;
         });
}

/// The first decision that lies within the wider of both bounds.
TieClass tie_class(const Admissible& subject, const Admissible& oracle) {
  const Admissible& wider = subject.candidates.size() > oracle.candidates.size() ? subject : oracle;
  if (wider.candidates.empty()) return TieClass::none;
  if (several_references(wider) || subject.candidates != oracle.candidates) {
    return TieClass::reference;
  }
  if (wider.candidates.size() > 1) return TieClass::incident;
  const Admissible& coarser =
      subject.bounds.separation > oracle.bounds.separation ? subject : oracle;
  if (contact_boundary(coarser)) return TieClass::contact_boundary;
  if (clip_boundary(coarser)) return TieClass::clip_boundary;
  return TieClass::none;
}

/// A normal is the reference face's: no other tie has to do with it. A boundary within bound
/// excuses a difference of two right manifolds; what is wrong lies beyond every bound, whatever
/// boundary is near.
TieClass relevant(TieClass tie_class, Verdict verdict, Kind kind) {
  const bool is_of_normal = kind == Kind::normal || kind == Kind::reversed;
  if (is_of_normal && tie_class != TieClass::reference) return TieClass::none;
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
std::optional<Bucket> without_manifold(const PairCase& pair, const Answer& answer, Fault fault) {
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    return bucket_of_lost(verdict_of(lost->how), fault);
  }
  if (says_sense(pair, answer)) return std::nullopt;
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
  if (const auto bucket = without_manifold(pair, subject.answer, Fault::subject)) return bucket;
  if (const auto bucket = without_manifold(pair, oracle.answer, Fault::oracle)) return bucket;
  if (std::holds_alternative<Unsupported>(subject.answer) ||
      std::holds_alternative<Unsupported>(oracle.answer)) {
    return Bucket{.verdict = Verdict::unsupported};
  }
  if (is_ill_posed(truth.size(), wider)) return Bucket{.verdict = Verdict::ill_posed};
  return std::nullopt;
}

/// One collider's manifold, what is right for it, and how it falls short.
struct Judged {
  Admissible right;
  Manifold<double> manifold;  ///< none of one that claims less
  Mismatch mismatch;
  bool by_curve = false;
  bool touches = false;

  bool is_wrong() const { return mismatch.kind != Kind::none; }
};

Judged judged(const std::shared_ptr<const exact::Truth>& truth, const ColliderAnswer& given) {
  Judged result{.right = admissible(truth, given.declaration), .manifold = {}, .mismatch = {}};
  result.by_curve = is_judged_by_curve(given.declaration);
  if (result.by_curve) {
    const CurveJudgement curve = judge_by_curve(*truth, given.declaration, given.answer);
    if (const auto* const manifold = manifold_in(given.answer)) result.manifold = *manifold;
    result.mismatch = {curve.kind, curve.magnitude};
    result.touches = touches(given.answer);
    return result;
  }
  result.manifold = manifold_of(given.answer, result.right);
  result.mismatch = mismatch(result.manifold, result.right);
  result.touches = result.manifold.count > 0;
  if (result.mismatch.kind == Kind::normal && is_reversed(*truth, given)) {
    result.mismatch.kind = Kind::reversed;
  }
  return result;
}

/// Of answers that are both right: whether they say the same, as far as both say it.
bool agree(const Judged& subject, const Judged& oracle) {
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
  const auto [kind, magnitude] = subject.is_wrong() ? subject.mismatch : oracle.mismatch;
  const bool is_of_normal = kind == Kind::normal || kind == Kind::reversed;
  return {kind, is_of_normal ? magnitude : magnitude / size};
}

}  // namespace

Standing standing(const exact::Truth& truth) {
  const double above = truth.separation() - total_radius(truth.pair());
  return {.touching = truth.compare_contact(0) <= 0,
          .near = std::abs(above) <= kNearShare * truth.size()};
}

Judgement judge(const std::shared_ptr<const exact::Truth>& truth, const ColliderAnswer& subject,
                const ColliderAnswer& oracle) {
  if (const auto bucket = without_judging(*truth, subject, oracle)) return {.bucket = *bucket};
  const Judged of_subject = judged(truth, subject);
  const Judged of_oracle = judged(truth, oracle);
  Judgement result{.of_subject = error_of(of_subject), .of_oracle = error_of(of_oracle)};
  Bucket& bucket = result.bucket;
  bucket.reference = truth->greatest().side;
  bucket.fault = fault_of(of_subject, of_oracle);
  if (bucket.fault == Fault::none && agree(of_subject, of_oracle)) return result;
  const Mismatch found = disagreement(of_subject, of_oracle, truth->size());
  bucket.verdict = verdict_of(bucket.fault);
  bucket.kind = found.kind;
  bucket.tie_class =
      relevant(tie_class(of_subject.right, of_oracle.right), bucket.verdict, bucket.kind);
  result.magnitude = found.magnitude;
  if (bucket.verdict == Verdict::oracle_wrong) {
    result.explanation = find_explanation(oracle.declaration.name,
                                          {of_oracle.right, of_oracle.manifold, found.kind});
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

namespace {

ContactSummary summary_of(const Manifold<double>& manifold) {
  if (manifold.count == 0) return {.kind = ContactSummary::Kind::apart};
  ContactSummary result{.kind = ContactSummary::Kind::contact,
                        .count = manifold.count,
                        .reference = manifold.reference};
  for (int i = 0; i < manifold.count; ++i) result.features[i] = manifold.points[i].features;
  return result;
}

}  // namespace

VertexOf deciding_vertex(const exact::Truth& truth) {
  const exact::FaceOf face = truth.greatest();
  return {other(face.side), truth.support(face)};
}

Grid grid_around(const exact::Truth& truth, int step) {
  const VertexOf vertex = deciding_vertex(truth);
  return {.vertex = vertex, .ulp = ulp_of(reach(truth.pair()[vertex.side].polygon)), .step = step};
}

std::optional<PairCase> neighbour(const PairCase& pair, const Grid& grid, int cell) {
  PairCase moved = pair;
  Vector2<float>& at = moved[grid.vertex.side].polygon.vertices[grid.vertex.index];
  const Vector2<double> steps(grid.x_of(cell), grid.y_of(cell));
  const Vector2<double> to = at.cast<double>() + grid.step * grid.ulp * steps;
  if (to.cwiseAbs().maxCoeff() > static_cast<double>(std::numeric_limits<float>::max())) {
    return std::nullopt;
  }
  at = to.cast<float>();
  return revalidated(moved);
}

ContactSummary summary_of(const Answer& answer) {
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr || manifold->count < 0 || manifold->count > 2) return {};
  return summary_of(*manifold);
}

ContactSummary summary_of(const exact::Truth& truth) {
  if (truth.compare_contact(0) > 0) return {.kind = ContactSummary::Kind::apart};
  const exact::FaceOf face = truth.greatest();
  const exact::Clip& clip = truth.clip(face, truth.incident_edges(face, 0).front());
  const Manifold<double> manifold = true_manifold(clip);
  if (manifold.count > 0) return summary_of(manifold);
  return {.kind = ContactSummary::Kind::no_clip, .reference = face.side};
}

bool fails_alike(const Bucket& bucket, const Bucket& finding) {
  if (finding.fault != Fault::none) {
    return bucket.fault == finding.fault || bucket.fault == Fault::both;
  }
  if (finding.verdict == Verdict::agree) return bucket.fault != Fault::none;
  return bucket.verdict == finding.verdict;
}

Severity severity(const Neighbourhood& neighbourhood, const Bucket& finding) {
  Severity result;
  for (const Cell& cell : neighbourhood.cells) {
    if (cell.state != Cell::State::judged) continue;
    ++result.valid;
    if (fails_alike(cell.bucket, finding)) ++result.failing;
  }
  return result;
}

}  // namespace manifuzz
