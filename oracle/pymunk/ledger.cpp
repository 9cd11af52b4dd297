#include "engines/engine.hpp"
#include "exact/placed.hpp"
#include "oracle/chipmunk/deviations.hpp"
#include "sequence/kept_faults.hpp"

// Munk2D, which pymunk holds, and whose other faults are Chipmunk's own.

namespace manifuzz {
namespace {

/// The middle of the box around a core, in world directions seen from A's position.
Vector2<double> middle_of(const exact::RoughPolygon& core) {
  Vector2<double> low = core.vertices[0];
  Vector2<double> high = low;
  for (int i = 1; i < core.count; ++i) {
    low = low.cwiseMin(core.vertices[i]);
    high = high.cwiseMax(core.vertices[i]);
  }
  return 0.5 * (low + high);
}

/// A normal without length. Boxes around both shapes have one middle, so that GJK begins with one
/// support point twice.
bool zero_normal_of_one_middle(const Deviation& d) {
  if (d.got.count == 0 || !d.got.normal.isZero(0)) return false;
  for (int i = 0; i < d.got.count; ++i) {
    if (d.got.points[i].depth != 0) return false;
  }
  const exact::RoughPair placed = exact::place_roughly(d.right.pair());
  return (middle_of(placed.a) - middle_of(placed.b)).norm() <= 4 * d.right.bounds.separation;
}

constexpr LedgerRow kLastOfPymunk[] = {
    {"zero-normal", zero_normal_of_one_middle},
    {"direction-between-corners", direction_between_corners},
    {"segment-normal-not-unit", segment_normal_not_unit},
};

bool detected_wrongly(const FrameView& view, const FrameJudgement& judgement) {
  return detected_by("pymunk", view, judgement);
}

constexpr SequenceRow kKeptRows[] = {{"detection", detected_wrongly}};

}  // namespace

Engine engine_pymunk() {
  static const auto first = rows_but_for({"polygon-radius-sign", "direction-between-corners",
                                          "segment-normal-not-unit", "epa-of-equal-corners"},
                                         kRowsOfMunk);
  return {.name = "pymunk",
          .ledger = {{"pymunk", first},
                     {"pymunk", kLastOfPymunk},
                     {"pymunk", kReplayedRowsOf<munk::kMunk>}},
          .sequence_ledger = {{"pymunk-kept", kKeptRows}}};
}

}  // namespace manifuzz
