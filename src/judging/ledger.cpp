#include "judging/ledger.hpp"

#include <algorithm>
#include <array>
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

/// The budgets of every entry, by its id.
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
  // Where it lies is fixed: a forked child says by an address which entry explains an answer.
  static std::array<LedgerEntry, kLedgerMax> entries;
  static const std::size_t count = [] {
    std::size_t next = 0;
    for (const BuiltLedger& built : built_ledgers()) {
      assert(next + built.entries.size() <= kLedgerMax);
      next = static_cast<std::size_t>(std::ranges::copy(built.entries, entries.begin() + next).out -
                                      entries.begin());
    }
    return next;
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
