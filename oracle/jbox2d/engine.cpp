#include "engines/engine.hpp"

#include <array>

#include "oracle/jbox2d/entries.hpp"

namespace manifuzz {

namespace {

constexpr std::array kLedger = joined(ledger_of::kOfJbox2d, ledger_of::kOfJbox2dSearch);

}  // namespace

Engine engine_jbox2d() {
  return {.name = "jbox2d", .ledger = kLedger};
}

}  // namespace manifuzz
