#include "judging/ledger.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include <fmt/format.h>

namespace manifuzz {

std::span<const LedgerEntry> ledger() {
  // Where it lies is fixed: a forked child says by an address which entry explains an answer.
  static std::array<LedgerEntry, kLedgerMax> entries;
  static const std::size_t count = [] {
    std::vector<LedgerEntry> built = built_ledger();
    assert(built.size() <= entries.size());
    std::ranges::move(built, entries.begin());
    return built.size();
  }();
  return {entries.data(), count};
}

namespace {

/// Filled before anything is forked.
[[maybe_unused]] const bool is_filled = !ledger().empty();

}  // namespace

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
