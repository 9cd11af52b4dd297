#include "engines/engine.hpp"

#include <array>

#include "oracle/rapier/contact_entries.hpp"
#include "oracle/rapier/entries.hpp"

namespace manifuzz {

namespace {

constexpr std::array kLedger = joined(ledger_of::kOfRapier, ledger_of::kOfRapierContact);

}  // namespace

Engine engine_rapier() {
  return {.name = "rapier", .ledger = kLedger};
}

}  // namespace manifuzz
