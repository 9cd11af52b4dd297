#include "judging/compare.hpp"

#include <algorithm>
#include <cmath>

#include "judging/manifold_error.hpp"

namespace manifuzz {
namespace {

/// Point by point, in order.
bool points_agree(const Manifold<double>& s, const Manifold<double>& o, double apart,
                  double deeper) {
  for (int i = 0; i < s.count; ++i) {
    const ContactPoint<double>& p = s.points[i];
    const ContactPoint<double>& q = o.points[i];
    if (!((p.position - q.position).norm() <= apart) || !(std::abs(p.depth - q.depth) <= deeper) ||
        p.features != q.features) {
      return false;
    }
  }
  return true;
}

bool plainly_agree(const exact::Truth& truth, const Declaration& of_subject,
                   const Manifold<double>& s, const Declaration& of_oracle,
                   const Manifold<double>& o) {
  if (s.count != o.count) return false;
  const Bounds for_subject = bounds(truth.pair(), of_subject, truth.extent());
  const Bounds for_oracle = bounds(truth.pair(), of_oracle, truth.extent());
  const Bounds& wider = for_subject.separation > for_oracle.separation ? for_subject : for_oracle;
  if (is_ill_posed(truth.size_at_least(), wider) && is_ill_posed(truth.size(), wider)) return false;
  if (s.count == 0) {
    return truth.compare_contact(-std::min(for_subject.separation, for_oracle.separation)) >= 0;
  }
  if (s.count < 0 || s.count > 2 || s.reference != o.reference || truth.compare_contact(0) > 0) {
    return false;
  }
  return (s.normal - o.normal).norm() <= for_subject.normal + for_oracle.normal &&
         points_agree(s, o, for_subject.position + for_oracle.position,
                      for_subject.separation + for_oracle.separation);
}

}  // namespace

bool plainly_agree(const exact::Truth& truth, const ColliderAnswer& subject,
                   const ColliderAnswer& oracle) {
  if (is_judged_by_curve(subject.declaration) || is_judged_by_curve(oracle.declaration)) {
    return false;
  }
  // Who gives no second point that the other gives is judged by its own policy.
  if (is_round(truth.pair()) &&
      subject.declaration.second_point != oracle.declaration.second_point) {
    return false;
  }
  if (used_by(subject.answer) != nullptr || used_by(oracle.answer) != nullptr) return false;
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

bool agree_within_bounds(const Manifold<double>& subject, const Admissible& right_for_subject,
                         const Manifold<double>& oracle, const Admissible& right_for_oracle) {
  if (subject.count != oracle.count) return false;
  if (subject.count == 0) return true;
  return std::ranges::any_of(right_for_subject.candidates, [&](const exact::Clip* clip) {
    return mismatch(subject, *clip, right_for_subject).kind == Kind::none &&
           mismatch(oracle, *clip, right_for_oracle).kind == Kind::none;
  });
}

Mismatch difference(const Manifold<double>& subject, const Manifold<double>& oracle,
                    double from_contact) {
  if (subject.count == 0) return {Kind::missed_contact, from_contact};
  if (oracle.count == 0) return {Kind::phantom_contact, from_contact};
  double magnitude = 0;
  for (int i = 0; i < subject.count; ++i) {
    const auto& point = subject.points[i];
    const auto distance = [&](const auto& other) {
      return (point.position - other.position).norm();
    };
    const bool second = oracle.count > 1 && distance(oracle.points[1]) < distance(oracle.points[0]);
    const auto& nearest = oracle.points[second ? 1 : 0];
    magnitude = std::max({magnitude, distance(nearest), std::abs(point.depth - nearest.depth)});
  }
  if (subject.reference != oracle.reference || subject.normal != oracle.normal) {
    return {Kind::normal, magnitude};
  }
  if (subject.count != oracle.count) return {Kind::count, magnitude};
  return {Kind::position, magnitude};
}

namespace {

bool several_references(const Admissible& right) {
  return std::ranges::any_of(right.candidates, [&](const exact::Clip* clip) {
    return clip->reference != right.candidates.front()->reference;
  });
}

bool contact_boundary(const Admissible& right) {
  if (right.may_touch && right.may_be_apart) return true;
  const exact::Clip& clip = *right.candidates.front();
  return std::ranges::any_of(
      points_of(clip), [&](const auto& point) { return is_at_zero_depth(right, clip, point); });
}

bool clip_boundary(const Admissible& right) {
  const exact::Clip& clip = *right.candidates.front();
  return clip.count < 2 || may_miss(right, clip) ||
         std::ranges::any_of(points_of(clip), [&](const auto& point) {
           return compare_margin(clip, point.end, right.bounds.separation) <= 0;
         });
}

}  // namespace

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

}  // namespace manifuzz
