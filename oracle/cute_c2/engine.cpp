#include "engines/engine.hpp"

#include "oracle/cute_c2/entries.hpp"

namespace manifuzz {

Engine engine_cute_c2() {
  return {.name = "cute_c2", .ledger = ledger_of::kOfCute};
}

}  // namespace manifuzz
