#include "judging/ledger.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace manifuzz {
namespace {

using Budgets = std::map<std::string, std::vector<Budget>, std::less<>>;

void add_budgets(std::string_view text, Budgets& budgets) {
  const auto of_entries = nlohmann::ordered_json::parse(text.empty() ? "{}" : text);
  for (const auto& [id, of_regimes] : of_entries.items()) {
    for (const auto& [regime, per_million] : of_regimes.items()) {
      budgets[id].push_back({regime, per_million.get<double>()});
    }
  }
}

/// Of every entry, by its id.
const Budgets& all_budgets() {
  static const Budgets all = [] {
    Budgets budgets;
    for (const BuiltLedger& built : built_ledgers()) add_budgets(built.budgets, budgets);
    return budgets;
  }();
  return all;
}

}  // namespace

std::span<const LedgerEntry> ledger() {
  static const std::vector<LedgerEntry> all = [] {
    std::vector<LedgerEntry> entries;
    for (const BuiltLedger& built : built_ledgers()) {
      entries.insert(entries.end(), built.entries.begin(), built.entries.end());
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

std::span<const Budget> budgets_of(const LedgerEntry& entry) {
  const auto found = all_budgets().find(entry.id);
  if (found == all_budgets().end()) return {};
  return found->second;
}

double budget_per_million(const LedgerEntry& entry, std::string_view regime) {
  const std::span<const Budget> budgets = budgets_of(entry);
  const auto found = std::ranges::find(budgets, regime, &Budget::regime);
  return found == budgets.end() ? 0 : found->per_million;
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
