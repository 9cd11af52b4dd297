#include "sequence/sequence_ledger.hpp"

#include <algorithm>
#include <array>

#include "sequence/kept_point.hpp"

namespace manifuzz {
namespace {

/// The point of which a fault is, in the frame that it is of.
const KeptPoint& point_of(const FrameView& view, const FrameJudgement& judgement) {
  const auto& points = judgement.kind == Kind::extent ? view.points_before() : view.points();
  return points[*judgement.point];
}

/// The normal stays as it was in the world while both bodies turn: what is wrong is the normal, or
/// that the point is taken for too stale along it, or not so.
bool normal_of_the_world(const FrameView& view, const FrameJudgement& judgement) {
  if (!judgement.point) return false;
  const KeptPoint& point = point_of(view, judgement);
  const KeptPoint& birth = view.birth_of(point);
  const double bound = view.bound().normal;
  if ((point.normal - birth.normal).norm() > bound) return false;
  if (judgement.kind == Kind::normal) return !view.is_born(point);
  if (judgement.kind != Kind::extent) return false;
  const AnchorsNow now = anchors_now(view.pair(), point, point.normal);
  return -now.depth > view.keeping().gap.of(view.pair()) - view.bound().gap ||
         now.drift > view.keeping().drift.of(view.pair()) - view.bound().gap;
}

/// A point too many takes the slot of an old one as areas between four have it, and on a line all
/// areas are 0.
bool slot_by_areas(const FrameView& view, const FrameJudgement& judgement) {
  if (judgement.kind != Kind::extent) return false;
  const auto& before = view.points_before();
  const bool was_full = static_cast<int>(before.size()) == view.keeping().points_max;
  return was_full && std::ranges::any_of(view.points(), [&](const KeptPoint& point) {
           return view.is_born(point) && std::ranges::none_of(before, [&](const KeptPoint& old) {
                    return old.id == point.id;
                  });
         });
}

bool detected_by(std::string_view engine, const FrameView& view, const FrameJudgement& judgement);

/// No point is as deep as they overlap since the one that is new is not.
bool detected_too_shallow(std::string_view engine, const FrameView& view) {
  for (std::size_t i = 0; i < view.points().size(); ++i) {
    if (!view.is_born(view.points()[i])) continue;
    FrameJudgement of_birth = judge_birth(view, view.points()[i]);
    of_birth.point = i;
    if (of_birth.kind != Kind::none && detected_by(engine, view, of_birth)) return true;
  }
  return false;
}

/// The answer as an engine gives it that keeps nothing: its entries explain what is detected.
bool detected_by(std::string_view engine, const FrameView& view, const FrameJudgement& judgement) {
  const bool is_anything_new = std::ranges::any_of(
      view.points(), [&](const KeptPoint& point) { return view.is_born(point); });
  const bool is_too_shallow = judgement.kind == Kind::depth;
  if (is_too_shallow && is_anything_new) return detected_too_shallow(engine, view);
  Manifold<double> got;
  if (judgement.point) {
    if (judgement.kind == Kind::extent) return false;
    const KeptPoint& point = point_of(view, judgement);
    if (!view.is_born(point)) return false;
    got = detected_on_b(view.pair(), point);
  }
  const Declaration& declaration = view.subject.declaration;
  const auto truth = std::make_shared<const exact::Truth>(view.pair());
  const Admissible right = admissible(truth, declaration);
  // What is kept hides that the contact was missed.
  const Kind kind = is_too_shallow ? Kind::missed_contact : judgement.kind;
  return find_explanation(engine, {right, got, kind}) != nullptr;
}

/// By bullet-epa: the same queries of the same prisms.
bool detected_by_epa(const FrameView& view, const FrameJudgement& judgement) {
  return detected_by("bullet-epa", view, judgement);
}

bool detected_by_planck(const FrameView& view, const FrameJudgement& judgement) {
  return detected_by("planck", view, judgement);
}

bool detected_by_munk(const FrameView& view, const FrameJudgement& judgement) {
  return detected_by("pymunk", view, judgement);
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

constexpr std::string_view kWorldNormal = "the normal stays in the world while both bodies turn";
constexpr std::string_view kWorldNormalSource =
    "Bullet 3.24, btPersistentManifold.cpp, refreshContactPoints: m_normalWorldOnB is never turned";
constexpr std::string_view kAreas =
    "a fifth point takes the slot of one that is deepest or at an end: areas on a line are 0";
constexpr std::string_view kAreasSource = "Bullet 3.24, btPersistentManifold.cpp, sortCachedPoints";

constexpr std::string_view kAxisSource =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual: "
    "normalInB = m_cachedSeparatingAxis where calcPenDepth is false";
constexpr std::string_view kEpaSource =
    "Bullet 3.24, btGjkPairDetector.cpp, getClosestPointsNonVirtual, and btGjkEpa2.cpp";

constexpr SequenceEntry entry_of(std::string_view id, std::string_view collider,
                                 std::string_view description, std::string_view source,
                                 bool (*explains)(const FrameView&, const FrameJudgement&)) {
  return {{.id = id, .collider = collider, .description = description, .source = source}, explains};
}

constexpr std::array kSequenceLedger{
    entry_of("bullet-cached-world-normal", "bullet-cached", kWorldNormal, kWorldNormalSource,
             normal_of_the_world),
    entry_of("bullet-cached-slot-by-areas", "bullet-cached", kAreas, kAreasSource, slot_by_areas),
    entry_of("bullet-cached-detection", "bullet-cached",
             "what is detected is wrong as bullet-epa's answers are", kEpaSource, detected_by_epa),
    entry_of("bullet-cached-axis-across-gap", "bullet-cached",
             "a gap below 0.001 has its width as distance, and an axis of before as normal",
             kAxisSource, axis_across_gap),
    entry_of("planck-kept-detection", "planck-kept",
             "what is detected is wrong as planck's answers are",
             "planck 1.5.0, CollidePolygon.js, CollidePolygons", detected_by_planck),
    entry_of("pymunk-kept-detection", "pymunk-kept",
             "what is detected is wrong as pymunk's answers are",
             "pymunk 7.3.0, Munk2D's cpCollision.c, cpCollide", detected_by_munk),
    entry_of("cached-bullet-world-normal", "cached-bullet", kWorldNormal, kWorldNormalSource,
             normal_of_the_world),
    entry_of("cached-bullet-slot-by-areas", "cached-bullet", kAreas, kAreasSource, slot_by_areas),
};

}  // namespace

std::span<const SequenceEntry> sequence_ledger() {
  return kSequenceLedger;
}

const LedgerEntry* find_sequence_explanation(const FrameView& view,
                                             const FrameJudgement& judgement) {
  // What keeps the points of another collider is named after both.
  const std::string_view name = view.subject.declaration.name;
  const std::string_view keeper = name.substr(0, name.find('+'));
  for (const SequenceEntry& known : kSequenceLedger) {
    if (known.entry.collider == keeper && known.explains(view, judgement)) {
      return &known.entry;
    }
  }
  return nullptr;
}

}  // namespace manifuzz
