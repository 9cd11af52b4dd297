#include "engines/engine.hpp"

#include "oracle/cp/entries.hpp"

namespace manifuzz {

Engine engine_cp() {
  return {.name = "cp", .ledger = ledger_of::kOfCp};
}

}  // namespace manifuzz
