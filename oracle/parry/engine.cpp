#include "engines/engine.hpp"

#include <array>

#include "oracle/parry/ledger/entries.hpp"
#include "oracle/parry/ledger/f64_entries.hpp"
#include "oracle/parry/ledger/simplified_entries.hpp"

namespace manifuzz {

namespace {

constexpr std::array kLedger =
    joined(ledger_of::kOfParry, ledger_of::kOfParryF64, ledger_of::kOfParrySimplified);

}  // namespace

Engine engine_parry() {
  return {.name = "parry", .ledger = kLedger};
}

}  // namespace manifuzz
