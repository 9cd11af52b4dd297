#include "engines/engine.hpp"

#include "oracle/godot3/entries.hpp"

namespace manifuzz {

Engine engine_godot3() {
  return {.name = "godot3", .ledger = ledger_of::kOfGodot};
}

}  // namespace manifuzz
