#include "engines/engine.hpp"

#include <array>

#include "oracle/planck/entries.hpp"
#include "sequence/kept_faults.hpp"

namespace manifuzz {
namespace {

bool detected_wrongly(const FrameView& view, const FrameJudgement& judgement) {
  return detected_by("planck", view, judgement);
}

constexpr std::array kKept{
    SequenceEntry{{.id = "planck-kept-detection",
                   .collider = "planck-kept",
                   .description = "what is detected is wrong as planck's answers are",
                   .source = "planck 1.5.0, CollidePolygon.js, CollidePolygons"},
                  detected_wrongly}};

}  // namespace

Engine engine_planck() {
  return {.name = "planck", .ledger = ledger_of::kOfPlanck, .sequence_ledger = kKept};
}

}  // namespace manifuzz
