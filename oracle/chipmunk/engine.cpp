#include "engines/engine.hpp"

#include "oracle/chipmunk/chipmunk_pass.hpp"
#include "oracle/chipmunk/deviations.hpp"

namespace manifuzz {
Engine engine_chipmunk() {
  return {.name = "chipmunk",
          .ledger = {{"chipmunk", kRowsOfMunk}, {"chipmunk", kReplayedRowsOf<munk::kChipmunk>}},
          .passes = {{"chipmunk", "chipmunk", "GJK, then clipping", chipmunk_pass}}};
}

}  // namespace manifuzz
