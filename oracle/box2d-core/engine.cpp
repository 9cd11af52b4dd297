#include "engines/engine.hpp"

#include "oracle/box2d-core/entries.hpp"

namespace manifuzz {

Engine engine_box2d_core() {
  return {.name = "box2d-core", .ledger = ledger_of::kOfBox2dCore};
}

}  // namespace manifuzz
