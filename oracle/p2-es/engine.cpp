#include "engines/engine.hpp"

#include "oracle/p2-es/entries.hpp"

namespace manifuzz {

Engine engine_p2_es() {
  return {.name = "p2-es", .ledger = ledger_of::kOfP2};
}

}  // namespace manifuzz
