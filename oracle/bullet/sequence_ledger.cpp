#include <cmath>

#include "exact/curve.hpp"
#include "oracle/bullet/ledger/rows.hpp"
#include "sequence/kept_faults.hpp"
#include "sequence/kept_point.hpp"

namespace manifuzz {
namespace {

/// The queries and the prisms are those of bullet-epa.
bool detected_by_epa(const FrameView& view, const FrameJudgement& judgement) {
  return detected_by("bullet-epa", view, judgement);
}

/// Where the solver of penetrations is asked about shapes that are apart, the distance is that of
/// its points, and the normal an axis of before; the anchor on A lies along it.
bool axis_across_gap(const FrameView& view, const FrameJudgement& judgement) {
  constexpr double asked_within = 0.001;  // gGjkEpaPenetrationTolerance
  if (!judgement.point || judgement.kind == Kind::extent) return false;
  const KeptPoint& point = point_of(view, judgement);
  const double bound = view.bound().birth.consistency;
  const exact::PenetrationCurve curve(view.truth, exact::Skin::round);
  return view.is_born(point) && point.depth <= bound && point.depth >= -asked_within - bound &&
         std::abs(point.depth - curve.least()) <= bound;
}

constexpr SequenceRow kSequenceRows[] = {
    {"world-normal", normal_of_the_world},
    {"slot-by-areas", slot_by_areas},
    {"detection", detected_by_epa},
    {"axis-across-gap", axis_across_gap},
};

}  // namespace

SequenceRows bullet_sequence_ledger() {
  return {"bullet-cached", kSequenceRows};
}

}  // namespace manifuzz
