#include "engines/engine.hpp"

#include "oracle/sat/entries.hpp"

namespace manifuzz {

Engine engine_sat() {
  return {.name = "sat", .ledger = ledger_of::kOfSat};
}

}  // namespace manifuzz
