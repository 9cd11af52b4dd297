#include "engines/engine.hpp"

#include <array>

#include "oracle/pymunk/entries.hpp"
#include "sequence/kept_faults.hpp"

namespace manifuzz {
namespace {

bool detected_wrongly(const FrameView& view, const FrameJudgement& judgement) {
  return detected_by("pymunk", view, judgement);
}

constexpr std::array kKept{
    SequenceEntry{{.id = "pymunk-kept-detection",
                   .collider = "pymunk-kept",
                   .description = "what is detected is wrong as pymunk's answers are",
                   .source = "pymunk 7.3.0, Munk2D's cpCollision.c, cpCollide"},
                  detected_wrongly}};

}  // namespace

Engine engine_pymunk() {
  return {.name = "pymunk", .ledger = ledger_of::kOfMunk, .sequence_ledger = kKept};
}

}  // namespace manifuzz
