#include "engines/engine.hpp"

#include "oracle/nape-js/entries.hpp"

namespace manifuzz {

Engine engine_nape_js() {
  return {.name = "nape-js", .ledger = ledger_of::kOfNape};
}

}  // namespace manifuzz
