#include "engines/engine.hpp"

#include "oracle/phaser-box2d/entries.hpp"

namespace manifuzz {

Engine engine_phaser_box2d() {
  return {.name = "phaser-box2d", .ledger = ledger_of::kOfPhaser};
}

}  // namespace manifuzz
