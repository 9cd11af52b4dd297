#include "engines/engine.hpp"

#include "oracle/matter-js/entries.hpp"

namespace manifuzz {

Engine engine_matter_js() {
  return {.name = "matter-js", .ledger = ledger_of::kOfMatter};
}

}  // namespace manifuzz
