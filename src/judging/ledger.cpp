#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "judging/ledger/box2d/box2d3_entries.hpp"
#include "judging/ledger/box2d/box2d_entries.hpp"
#include "judging/ledger/box2d/javascript_entries.hpp"
#include "judging/ledger/bullet/bullet_entries.hpp"
#include "judging/ledger/bullet/bullet_epa_entries.hpp"
#include "judging/ledger/bullet/bullet_query_entries.hpp"
#include "judging/ledger/bullet/displaced_entries.hpp"
#include "judging/ledger/bullet/perturbed_entries.hpp"
#include "judging/ledger/bullet/rounded_entries.hpp"
#include "judging/ledger/chipmunk/chipmunk_entries.hpp"
#include "judging/ledger/chipmunk/cp_entries.hpp"
#include "judging/ledger/chipmunk/munk_entries.hpp"
#include "judging/ledger/libccd/libccd_entries.hpp"
#include "judging/ledger/npm/box2d_core_entries.hpp"
#include "judging/ledger/npm/matter_entries.hpp"
#include "judging/ledger/npm/nape_entries.hpp"
#include "judging/ledger/npm/p2_entries.hpp"
#include "judging/ledger/parry/parry_entries.hpp"
#include "judging/ledger/parry/parry_f64_entries.hpp"
#include "judging/ledger/parry/parry_simplified_entries.hpp"
#include "judging/ledger/parry/rapier_contact_entries.hpp"
#include "judging/ledger/parry/rapier_entries.hpp"
#include "judging/ledger/separating_axes/cute_entries.hpp"
#include "judging/ledger/separating_axes/dyn4j_entries.hpp"
#include "judging/ledger/separating_axes/godot_entries.hpp"
#include "judging/ledger/separating_axes/jbox2d_entries.hpp"
#include "judging/ledger/separating_axes/sat_entries.hpp"

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
    ledger_of::kOfCp, ledger_of::kOfJbox2d, ledger_of::kOfBullet, ledger_of::kOfLibccd,
    ledger_of::kOfBox2d3, ledger_of::kOfBox2dCore, ledger_of::kOfMatter, ledger_of::kOfP2,
    ledger_of::kOfNape, ledger_of::kOfDyn4jSat, ledger_of::kOfDyn4jGjk, ledger_of::kOfCute,
    ledger_of::kOfSat, ledger_of::kOfGodot, ledger_of::kOfJbox2dSearch, ledger_of::kOfParry,
    ledger_of::kOfParryF64, ledger_of::kOfParrySimplified, ledger_of::kOfRapier,
    ledger_of::kOfRapierContact, ledger_of::kOfBulletEpa, ledger_of::kOfBulletQuery,
    ledger_of::kOfBulletDisplaced, ledger_of::kOfBulletPerturbed, ledger_of::kOfBulletPerturbedEpa,
    ledger_of::kOfBulletRounded);

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
    if (entry.collider != collider || entry.explains == nullptr) continue;
    if (entry.explains(deviation)) return &entry;
  }
  return nullptr;
}

const LedgerEntry* find_explanation(std::string_view collider, const LostAnswer& lost) {
  for (const LedgerEntry& entry : kLedger) {
    if (entry.collider != collider || entry.explains_lost == nullptr) continue;
    if (entry.explains_lost(lost)) return &entry;
  }
  return nullptr;
}

}  // namespace manifuzz
