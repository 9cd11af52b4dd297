#include "judging/judge.hpp"

#include <algorithm>
#include <optional>

#include "judging/completed.hpp"

namespace manifuzz {
namespace {

using exact::Clip;

double distance(const Vector2<double>& p, const Vector2<double>& q) {
  const Vector2<double> apart = p - q;
  return std::sqrt(apart.dot(apart));
}

bool matches_one(const Manifold<double>& manifold, const Clip& clip, const Admissible& right) {
  return mismatch(manifold, clip, right).kind == Kind::none;
}

/// Both match one candidate within their own bounds, hence each other within the sum.
bool agree_within_bounds(const Manifold<double>& subject, const Admissible& right_for_subject,
                         const Manifold<double>& oracle, const Admissible& right_for_oracle) {
  if (subject.count != oracle.count) return false;
  if (subject.count == 0) return true;
  return std::ranges::any_of(right_for_subject.candidates, [&](const Clip* clip) {
    return matches_one(subject, *clip, right_for_subject) &&
           matches_one(oracle, *clip, right_for_oracle);
  });
}

/// How two right manifolds differ: the kind, and the magnitude as a world length.
Mismatch difference(const Manifold<double>& subject, const Manifold<double>& oracle,
                    double from_contact) {
  if (subject.count == 0) return {Kind::missed_contact, from_contact};
  if (oracle.count == 0) return {Kind::phantom_contact, from_contact};
  double apart = 0;
  double deeper = 0;
  for (int i = 0; i < subject.count; ++i) {
    const auto& point = subject.points[i];
    const auto* nearest = &oracle.points[0];
    for (int j = 1; j < oracle.count; ++j) {
      if (distance(point.position, oracle.points[j].position) <
          distance(point.position, nearest->position)) {
        nearest = &oracle.points[j];
      }
    }
    apart = std::max(apart, distance(point.position, nearest->position));
    deeper = std::max(deeper, std::abs(point.depth - nearest->depth));
  }
  const double magnitude = std::max(apart, deeper);
  if (subject.reference != oracle.reference || subject.normal != oracle.normal) {
    return {Kind::normal, magnitude};
  }
  if (subject.count != oracle.count) return {Kind::count, magnitude};
  return {Kind::position, magnitude};
}

bool several_references(const Admissible& right) {
  return std::ranges::any_of(right.candidates, [&](const Clip* clip) {
    return clip->reference != right.candidates.front()->reference;
  });
}

bool contact_boundary(const Admissible& right) {
  if (right.may_touch && right.may_be_apart) return true;
  const Clip& clip = *right.candidates.front();
  return std::any_of(clip.points.begin(), clip.points.begin() + clip.count, [&](const auto& point) {
    const double bound = depth_bound(right, clip, point);
    return compare_depth(clip, point, bound) <= 0 && compare_depth(clip, point, -bound) >= 0;
  });
}

bool clip_boundary(const Admissible& right) {
  const Clip& clip = *right.candidates.front();
  return clip.count < 2 || may_miss(right, clip) ||
         std::any_of(clip.points.begin(), clip.points.begin() + clip.count, [&](const auto& point) {
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
  if (kind == Kind::normal && tie_class != TieClass::reference) return TieClass::none;
  const bool boundary =
      tie_class == TieClass::contact_boundary || tie_class == TieClass::clip_boundary;
  return boundary && verdict != Verdict::tie ? TieClass::none : tie_class;
}

/// A magnitude in world lengths as a share of the size; a normal's is a share already.
double share(const Mismatch& mismatch, double size) {
  return mismatch.kind == Kind::normal ? mismatch.magnitude : mismatch.magnitude / size;
}

bool is_ill_posed(const exact::Truth& truth, const Declaration& declaration) {
  return manifuzz::is_ill_posed(truth.size(), bounds(truth.pair(), declaration, truth.extent()));
}

/// What overflows in the collider's scalar is no nonsense of the collider's.
bool may_overflow(const exact::Truth& truth, const Declaration& declaration) {
  return !std::isfinite(bounds(truth.pair(), declaration, truth.extent()).separation);
}

/// The manifold of an answer, complete or not; nullptr where there is none.
const Manifold<double>* manifold_in(const Answer& answer) {
  if (const auto* const partial = std::get_if<PartialManifold>(&answer)) return &partial->manifold;
  return std::get_if<Manifold<double>>(&answer);
}

Manifold<double> manifold_of(const Answer& answer, const Admissible& right) {
  if (const auto* const partial = std::get_if<PartialManifold>(&answer)) {
    return completed(*partial, right);
  }
  return std::get<Manifold<double>>(answer);
}

Verdict verdict_of(Lost::How how) {
  switch (how) {
    case Lost::How::crashed:
      return Verdict::crashed;
    case Lost::How::timed_out:
      return Verdict::timed_out;
    default:
      return Verdict::malformed;
  }
}

/// What a party's answer comes to by itself: lost, or nonsense.
std::optional<Bucket> without_manifold(const PairCase& pair, const Answer& answer, Fault party) {
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    return bucket_of_lost(verdict_of(lost->how), party);
  }
  const Manifold<double>* const manifold = manifold_in(answer);
  if (manifold == nullptr || is_well_formed(pair, *manifold)) return std::nullopt;
  return bucket_of_lost(Verdict::malformed, party);
}

/// A verdict that needs no judging of manifolds, if it is one.
std::optional<Bucket> without_judging(const exact::Truth& truth, const ColliderAnswer& subject,
                                      const ColliderAnswer& oracle) {
  const PairCase& pair = truth.pair();
  if (may_overflow(truth, subject.declaration) || may_overflow(truth, oracle.declaration)) {
    return Bucket{.verdict = Verdict::ill_posed};
  }
  if (const auto bucket = without_manifold(pair, subject.answer, Fault::subject)) return bucket;
  if (const auto bucket = without_manifold(pair, oracle.answer, Fault::oracle)) return bucket;
  if (manifold_in(subject.answer) == nullptr || manifold_in(oracle.answer) == nullptr) {
    return Bucket{.verdict = Verdict::unsupported};
  }
  if (is_ill_posed(truth, subject.declaration) || is_ill_posed(truth, oracle.declaration)) {
    return Bucket{.verdict = Verdict::ill_posed};
  }
  return std::nullopt;
}

struct Wrongs {
  Mismatch subject;
  Mismatch oracle;

  Fault fault() const {
    const bool of_subject = subject.kind != Kind::none;
    const bool of_oracle = oracle.kind != Kind::none;
    if (of_subject && of_oracle) return Fault::both;
    return of_subject ? Fault::subject : of_oracle ? Fault::oracle : Fault::none;
  }
};

Verdict verdict_of(Fault fault) {
  switch (fault) {
    case Fault::subject:
      return Verdict::subject_wrong;
    case Fault::oracle:
      return Verdict::oracle_wrong;
    case Fault::both:
      return Verdict::both_wrong;
    default:
      return Verdict::tie;
  }
}

bool plainly_agree(const exact::Truth& truth, const Declaration& of_subject,
                   const Manifold<double>& s, const Declaration& of_oracle,
                   const Manifold<double>& o) {
  if (s.count != o.count) return false;
  const Bounds for_subject = bounds(truth.pair(), of_subject, truth.extent());
  const Bounds for_oracle = bounds(truth.pair(), of_oracle, truth.extent());
  if (is_ill_posed(truth.size(), for_subject) || is_ill_posed(truth.size(), for_oracle)) {
    return false;
  }
  if (s.count == 0) return truth.compare_contact(for_subject.separation) > 0;
  if (s.count < 0 || s.count > 2 || s.reference != o.reference || truth.compare_contact(0) > 0) {
    return false;
  }
  if (!(distance(s.normal, o.normal) <= for_subject.normal + for_oracle.normal)) return false;
  const double apart = for_subject.position + for_oracle.position;
  const double deeper = for_subject.separation + for_oracle.separation;
  for (int i = 0; i < s.count; ++i) {
    if (!(distance(s.points[i].position, o.points[i].position) <= apart) ||
        !(std::abs(s.points[i].depth - o.points[i].depth) <= deeper) ||
        s.points[i].features != o.points[i].features) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool is_well_formed(const PairCase& pair, const Manifold<double>& m) {
  if (m.count < 0 || m.count > 2) return false;
  if (m.count > 0 && !m.normal.allFinite()) return false;
  const auto exists = [](const Feature& feature, const Body& body) {
    return feature.index < body.polygon.count;
  };
  return std::all_of(m.points.begin(), m.points.begin() + m.count, [&](const auto& point) {
    return point.position.allFinite() && std::isfinite(point.depth) && point.depth >= 0 &&
           exists(point.features.a, pair.a) && exists(point.features.b, pair.b);
  });
}

Standing standing(const exact::Truth& truth) {
  const double above = truth.separation() - total_radius(truth.pair());
  return {.touching = truth.compare_contact(0) <= 0,
          .near = std::abs(above) <= kNearShare * truth.size()};
}

bool plainly_agree(const exact::Truth& truth, const ColliderAnswer& subject,
                   const ColliderAnswer& oracle) {
  const auto* const s = std::get_if<Manifold<double>>(&subject.answer);
  const auto* const o = std::get_if<Manifold<double>>(&oracle.answer);
  if (s && o) return plainly_agree(truth, subject.declaration, *s, oracle.declaration, *o);
  if (const auto* const p = std::get_if<PartialManifold>(&subject.answer); p && o) {
    return plainly_agree(truth, subject.declaration, completed(*p, truth.pair(), *o),
                         oracle.declaration, *o);
  }
  if (const auto* const p = std::get_if<PartialManifold>(&oracle.answer); p && s) {
    return plainly_agree(truth, subject.declaration, *s, oracle.declaration,
                         completed(*p, truth.pair(), *s));
  }
  return false;
}

Judgement judge(std::shared_ptr<const exact::Truth> truth, const ColliderAnswer& subject,
                const ColliderAnswer& oracle) {
  if (const auto bucket = without_judging(*truth, subject, oracle)) return {.bucket = *bucket};
  const Admissible right_for_subject = admissible(truth, subject.declaration);
  const Admissible right_for_oracle = admissible(truth, oracle.declaration);
  const Manifold<double> of_subject = manifold_of(subject.answer, right_for_subject);
  const Manifold<double> of_oracle = manifold_of(oracle.answer, right_for_oracle);
  const Wrongs wrongs{mismatch(of_subject, right_for_subject),
                      mismatch(of_oracle, right_for_oracle)};

  Judgement result;
  if (wrongs.subject.kind != Kind::none) {
    result.of_subject = share_of_size(plain_error(of_subject, right_for_subject), truth->size());
  }
  if (wrongs.oracle.kind != Kind::none) {
    result.of_oracle = share_of_size(plain_error(of_oracle, right_for_oracle), truth->size());
  }
  result.bucket.reference = truth->greatest().side;
  result.bucket.fault = wrongs.fault();
  if (result.bucket.fault == Fault::none &&
      agree_within_bounds(of_subject, right_for_subject, of_oracle, right_for_oracle)) {
    return result;
  }
  result.bucket.verdict = verdict_of(result.bucket.fault);
  if (result.bucket.fault == Fault::none) {
    const Mismatch apart = difference(of_subject, of_oracle, right_for_subject.from_contact());
    result.bucket.kind = apart.kind;
    result.magnitude = apart.magnitude / truth->size();
  } else {
    const Mismatch& worst = result.bucket.fault == Fault::oracle ? wrongs.oracle : wrongs.subject;
    result.bucket.kind = worst.kind;
    result.magnitude = share(worst, truth->size());
  }
  result.bucket.tie_class = relevant(tie_class(right_for_subject, right_for_oracle),
                                     result.bucket.verdict, result.bucket.kind);
  if (result.bucket.verdict == Verdict::oracle_wrong) {
    result.explanation = find_explanation(oracle.declaration.name,
                                          {right_for_oracle, of_oracle, wrongs.oracle.kind});
    if (result.explanation != nullptr) result.bucket.verdict = Verdict::known;
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

Bucket bucket_of_lost(Verdict verdict, Fault fault) {
  return {.fault = fault, .verdict = verdict};
}

}  // namespace manifuzz
