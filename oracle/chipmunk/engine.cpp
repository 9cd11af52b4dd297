#include "engines/engine.hpp"

#include "oracle/chipmunk/chipmunk_pass.hpp"
#include "oracle/chipmunk/entries.hpp"

namespace manifuzz {

Engine engine_chipmunk() {
  return {.name = "chipmunk",
          .ledger = ledger_of::kOfChipmunk,
          .passes = {{"chipmunk", "chipmunk", "GJK, then clipping", chipmunk_pass}}};
}

}  // namespace manifuzz
