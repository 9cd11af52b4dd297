#include "engines/engine.hpp"

#include <array>

#include "oracle/dyn4j/entries.hpp"

namespace manifuzz {

namespace {

constexpr std::array kLedger = joined(ledger_of::kOfDyn4jSat, ledger_of::kOfDyn4jGjk);

}  // namespace

Engine engine_dyn4j() {
  return {.name = "dyn4j", .ledger = kLedger};
}

}  // namespace manifuzz
