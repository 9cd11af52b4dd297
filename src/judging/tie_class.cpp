#include "judging/tie_class.hpp"

#include <algorithm>

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
