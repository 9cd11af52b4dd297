#include "oracle/bullet/sequence_ledger.hpp"

#include <array>
#include <cmath>

#include "exact/curve.hpp"
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

constexpr std::string_view kAxisSource =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "normalInB = m_cachedSeparatingAxis where calcPenDepth is false";
constexpr std::string_view kEpaSource =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual, and btGjkEpa2.cpp";

constexpr SequenceEntry entry_of(std::string_view id, std::string_view description,
                                 std::string_view source,
                                 bool (*explains)(const FrameView&, const FrameJudgement&)) {
  return {{.id = id, .collider = "bullet-cached", .description = description, .source = source},
          explains};
}

constexpr std::array kSequenceLedger{
    entry_of("bullet-cached-world-normal", kWorldNormal, kWorldNormalSource, normal_of_the_world),
    entry_of("bullet-cached-slot-by-areas", kAreas, kAreasSource, slot_by_areas),
    entry_of("bullet-cached-detection", "what is detected is wrong as bullet-epa's answers are",
             kEpaSource, detected_by_epa),
    entry_of("bullet-cached-axis-across-gap",
             "a gap below 0.001 has its width as distance, and an axis of before as normal",
             kAxisSource, axis_across_gap),
};

}  // namespace

std::span<const SequenceEntry> bullet_sequence_ledger() {
  return kSequenceLedger;
}

}  // namespace manifuzz
