#include "judging/compare.hpp"

#include <algorithm>
#include <cmath>

#include "judging/completed.hpp"

namespace manifuzz {
namespace {

double distance(const Vector2<double>& p, const Vector2<double>& q) {
  const Vector2<double> apart = p - q;
  return std::sqrt(apart.dot(apart));
}

/// Point by point, in order.
bool points_agree(const Manifold<double>& s, const Manifold<double>& o, double apart,
                  double deeper) {
  for (int i = 0; i < s.count; ++i) {
    const ContactPoint<double>& p = s.points[i];
    const ContactPoint<double>& q = o.points[i];
    if (!(distance(p.position, q.position) <= apart) || !(std::abs(p.depth - q.depth) <= deeper) ||
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
  if (is_ill_posed(truth.size(), for_subject) || is_ill_posed(truth.size(), for_oracle)) {
    return false;
  }
  if (s.count == 0) return truth.compare_contact(for_subject.separation) > 0;
  if (s.count < 0 || s.count > 2 || s.reference != o.reference || truth.compare_contact(0) > 0) {
    return false;
  }
  return distance(s.normal, o.normal) <= for_subject.normal + for_oracle.normal &&
         points_agree(s, o, for_subject.position + for_oracle.position,
                      for_subject.separation + for_oracle.separation);
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
    const auto* nearest = &oracle.points[0];
    for (int j = 1; j < oracle.count; ++j) {
      if (distance(point.position, oracle.points[j].position) <
          distance(point.position, nearest->position)) {
        nearest = &oracle.points[j];
      }
    }
    magnitude = std::max({magnitude, distance(point.position, nearest->position),
                          std::abs(point.depth - nearest->depth)});
  }
  if (subject.reference != oracle.reference || subject.normal != oracle.normal) {
    return {Kind::normal, magnitude};
  }
  if (subject.count != oracle.count) return {Kind::count, magnitude};
  return {Kind::position, magnitude};
}

}  // namespace manifuzz
