#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "judging/ledger/box2d/box2d3_entries.hpp"
#include "judging/ledger/box2d/box2d_entries.hpp"
#include "judging/ledger/box2d/javascript_entries.hpp"
#include "judging/ledger/bullet/bullet_entries.hpp"
#include "judging/ledger/bullet/bullet_epa_entries.hpp"
#include "judging/ledger/bullet/bullet_query_entries.hpp"
#include "judging/ledger/bullet/libccd_entries.hpp"
#include "judging/ledger/chipmunk/chipmunk_entries.hpp"
#include "judging/ledger/chipmunk/munk_entries.hpp"

namespace manifuzz {
namespace {

template <class... Entries>
constexpr auto joined(const Entries&... entries) {
  std::array<LedgerEntry, (std::tuple_size_v<Entries> + ...)> all{};
  std::size_t next = 0;
  const auto append = [&](const auto& some) {
    for (const LedgerEntry& entry : some) all[next++] = entry;
  };
  (append(entries), ...);
  return all;
}

constexpr std::array kLedger = joined(
    ledger_of::kOfBox2d, ledger_of::kOfJavaScript, ledger_of::kOfChipmunk, ledger_of::kOfMunk,
    ledger_of::kOfCp, ledger_of::kOfJbox2d, ledger_of::kOfBullet, ledger_of::kOfBulletEpa,
    ledger_of::kOfBulletQuery, ledger_of::kOfLibccd, ledger_of::kOfBox2d3);

static_assert(kLedger.size() <= kLedgerMax);

}  // namespace

std::span<const LedgerEntry> ledger() {
  return kLedger;
}

std::size_t index_of(const LedgerEntry& entry) {
  return static_cast<std::size_t>(&entry - kLedger.data());
}

std::string witness_of(const LedgerEntry& entry) {
  return fmt::format("defects/{}/witness-{}.json", entry.collider, entry.id);
}

double budget_per_million(const LedgerEntry& entry, std::string_view regime) {
  const auto found = std::ranges::find(entry.budgets, regime, &Budget::regime);
  return found == entry.budgets.end() ? 0 : found->per_million;
}

const LedgerEntry* find_explanation(std::string_view collider, const Deviation& deviation) {
  for (const LedgerEntry& entry : kLedger) {
    if (entry.collider == collider && entry.explains(deviation)) return &entry;
  }
  return nullptr;
}

}  // namespace manifuzz
