#include "judging/ledger.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

#include <fmt/format.h>

namespace manifuzz {

std::span<const LedgerEntry> ledger() {
  static const std::vector<LedgerEntry> all = [] {
    std::vector<LedgerEntry> entries;
    for (const std::span<const LedgerEntry> of_engine : built_ledgers()) {
      entries.insert(entries.end(), of_engine.begin(), of_engine.end());
    }
    assert(entries.size() <= kLedgerMax);
    return entries;
  }();
  return all;
}

std::size_t index_of(const LedgerEntry& entry) {
  return static_cast<std::size_t>(&entry - ledger().data());
}

std::string witness_of(const LedgerEntry& entry) {
  return fmt::format("defects/{}/witness-{}.json", entry.collider, entry.id);
}

double budget_per_million(const LedgerEntry& entry, std::string_view regime) {
  const auto found = std::ranges::find(entry.budgets, regime, &Budget::regime);
  return found == entry.budgets.end() ? 0 : found->per_million;
}

const LedgerEntry* find_explanation(std::string_view collider, const Deviation& deviation) {
  for (const LedgerEntry& entry : ledger()) {
    if (entry.collider != collider || entry.explains == nullptr) continue;
    if (entry.explains(deviation)) return &entry;
  }
  return nullptr;
}

const LedgerEntry* find_explanation(std::string_view collider, const LostAnswer& lost) {
  for (const LedgerEntry& entry : ledger()) {
    if (entry.collider != collider || entry.explains_lost == nullptr) continue;
    if (entry.explains_lost(lost)) return &entry;
  }
  return nullptr;
}

}  // namespace manifuzz
