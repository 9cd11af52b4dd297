#include "support/twin.hpp"

#include "judging/by_curve.hpp"
#include "support/twin_curve.hpp"
#include "support/twin_facts.hpp"
#include "support/twin_round.hpp"

namespace manifuzz {
namespace {

using twin::Twin;
using twin::TwinClip;

bool same(const TwinClip& p, const TwinClip& q) {
  return p.candidate == q.candidate;
}

TieClass tie_class(const Twin& subject, const Twin& oracle) {
  const Twin& wider = subject.clips().size() > oracle.clips().size() ? subject : oracle;
  if (wider.clips().empty()) return TieClass::none;
  const TwinCandidate& first = wider.clips().front().candidate;
  for (const TwinClip& clip : wider.clips()) {
    if (clip.candidate.side != first.side || clip.candidate.reference != first.reference) {
      return TieClass::reference;
    }
  }
  if (!std::ranges::equal(subject.clips(), oracle.clips(), same)) return TieClass::reference;
  if (wider.clips().size() > 1) return TieClass::incident;
  const Twin& coarser = subject.bound() > oracle.bound() ? subject : oracle;
  if (coarser.contact_boundary()) return TieClass::contact_boundary;
  return coarser.clip_boundary() ? TieClass::clip_boundary : TieClass::none;
}

/// How two right manifolds differ.
Kind difference(const Manifold<double>& subject, const Manifold<double>& oracle) {
  if (subject.count == 0) return Kind::missed_contact;
  if (oracle.count == 0) return Kind::phantom_contact;
  if (subject.reference != oracle.reference || subject.normal != oracle.normal) return Kind::normal;
  if (subject.count != oracle.count) return Kind::count;
  return Kind::position;
}

/// A wrong normal that points from B to A: turned about it has the least depth, and that depth.
Kind or_reversed(Kind kind, const PairCase& pair, const Declaration& declaration,
                 const Manifold<double>& manifold) {
  if (kind != Kind::normal || manifold.normal.isZero(0)) return kind;
  const CurveBounds allowed = curve_bounds(pair, declaration, extent(pair));
  const twin::TwinCurve curve(pair, false);
  const Vector2<double> back = -manifold.normal;
  const Real depth = curve.depth(back);
  const auto is_least = [&](const Real& least) {
    return magnitude(depth - least) <= Real(allowed.minimality);
  };
  // Depths are total radii less separations.
  const TieBias& bias = declaration.tie_bias;
  const auto separation_of = [&](Side side) {
    return Real(total_radius(pair)) - curve.least_of(side);
  };
  const Real lead =
      separation_of(other(bias.towards)) - Real(1 - bias.relative) * separation_of(bias.towards);
  const bool is_let = !bias.is_none() && lead <= Real(bias.absolute + allowed.touching);
  if (!is_least(curve.least()) && !(is_let && is_least(curve.least_of(bias.towards)))) return kind;
  double deepest = 0;
  for (int i = 0; i < manifold.count; ++i) deepest = std::max(deepest, manifold.points[i].depth);
  const Real overlap = curve.gap(back).value_or(depth);
  const auto is_within = [&](double low, double high) {
    return Real(low) <= overlap && overlap <= Real(high);
  };
  return is_within(deepest - allowed.consistency, deepest + allowed.consistency) ? Kind::reversed
                                                                                 : kind;
}

void blame(Bucket& bucket, Kind wrong_subject, Kind wrong_oracle) {
  const bool is_subject = wrong_subject != Kind::none;
  const bool is_oracle = wrong_oracle != Kind::none;
  bucket.fault = is_subject && is_oracle ? Fault::both
                 : is_subject            ? Fault::subject
                                         : Fault::oracle;
  bucket.verdict = is_subject && is_oracle ? Verdict::both_wrong
                   : is_subject            ? Verdict::subject_wrong
                                           : Verdict::oracle_wrong;
  bucket.kind = is_subject ? wrong_subject : wrong_oracle;
}

void judge_mitred(const PairCase& pair, const Twin& for_subject, const Declaration& subject,
                  const Manifold<double>& of_subject, const Declaration& oracle,
                  const Manifold<double>& of_oracle, Bucket& bucket) {
  const Twin for_oracle(pair, oracle);
  const Kind wrong_subject = or_reversed(for_subject.wrong(of_subject), pair, subject, of_subject);
  const Kind wrong_oracle = or_reversed(for_oracle.wrong(of_oracle), pair, oracle, of_oracle);
  bucket.reference = for_subject.reference();
  const bool both_right = wrong_subject == Kind::none && wrong_oracle == Kind::none;
  if (both_right && of_subject.count == of_oracle.count) {
    bool agree = of_subject.count == 0;
    for (const TwinClip& clip : for_subject.clips()) {
      agree = agree || (for_subject.wrong(of_subject, clip) == Kind::none &&
                        for_oracle.wrong(of_oracle, clip) == Kind::none);
    }
    if (agree) return;
  }
  if (both_right) {
    bucket.verdict = Verdict::tie;
    bucket.kind = difference(of_subject, of_oracle);
  } else {
    blame(bucket, wrong_subject, wrong_oracle);
  }
  bucket.tie_class = tie_class(for_subject, for_oracle);
  const bool is_normal = bucket.kind == Kind::normal || bucket.kind == Kind::reversed;
  const bool of_normal = is_normal && bucket.tie_class != TieClass::reference;
  const bool at_boundary =
      bucket.tie_class == TieClass::contact_boundary || bucket.tie_class == TieClass::clip_boundary;
  if (of_normal || (at_boundary && bucket.verdict != Verdict::tie)) {
    bucket.tie_class = TieClass::none;
  }
}

/// Two right answers agree where both touch or neither does.
void judge_round(const twin::RoundTwin& pair, const Declaration& subject,
                 const Manifold<double>& of_subject, const Declaration& oracle,
                 const Manifold<double>& of_oracle, Bucket& bucket) {
  bucket.reference = pair.reference();
  const Kind wrong_subject = pair.wrong(subject, of_subject);
  const Kind wrong_oracle = pair.wrong(oracle, of_oracle);
  if (wrong_subject != Kind::none || wrong_oracle != Kind::none) {
    blame(bucket, wrong_subject, wrong_oracle);
  } else if ((of_subject.count > 0) != (of_oracle.count > 0)) {
    bucket.verdict = Verdict::tie;
    bucket.kind = of_subject.count > 0 ? Kind::phantom_contact : Kind::missed_contact;
  }
}

}  // namespace

TwinJudgement twin_judge(const PairCase& pair, const ColliderAnswer& subject,
                         const ColliderAnswer& oracle) {
  TwinJudgement result;
  std::optional<Twin> for_subject;
  if (is_round(pair)) {
    result.touching = twin::RoundTwin(pair).touches();
  } else {
    for_subject.emplace(pair, subject.declaration);
    result.touching = for_subject->touches();
    for (const TwinClip& clip : for_subject->clips()) result.candidates.push_back(clip.candidate);
  }
  const auto* of_subject = std::get_if<Manifold<double>>(&subject.answer);
  const auto* of_oracle = std::get_if<Manifold<double>>(&oracle.answer);
  Bucket& bucket = result.bucket;
  if (!of_subject || !of_oracle) {
    bucket.verdict = Verdict::unsupported;
    return result;
  }
  if (for_subject) {
    judge_mitred(pair, *for_subject, subject.declaration, *of_subject, oracle.declaration,
                 *of_oracle, bucket);
  } else {
    judge_round(twin::RoundTwin(pair), subject.declaration, *of_subject, oracle.declaration,
                *of_oracle, bucket);
  }
  const bool is_hidden = is_ill_posed(size(pair), bounds(pair, subject.declaration)) ||
                         is_ill_posed(size(pair), bounds(pair, oracle.declaration));
  if (is_hidden && bucket.fault == Fault::none) bucket = {.verdict = Verdict::ill_posed};
  return result;
}

}  // namespace manifuzz
