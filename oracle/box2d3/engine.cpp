#include "engines/engine.hpp"

#include "oracle/box2d3/entries.hpp"

namespace manifuzz {

Engine engine_box2d3() {
  return {.name = "box2d3", .ledger = ledger_of::kOfBox2d3};
}

}  // namespace manifuzz
