#include "hunting/elite.hpp"

#include <algorithm>

namespace manifuzz {
namespace {

/// How many cases of each gauge are kept. Of few, all soon descend from one case.
constexpr std::size_t kElite = 512;

}  // namespace

bool Elite::takes(std::size_t gauge, const Observation& observed) const {
  if (!aim_.seeks(gauge)) return false;
  const auto& elite = of_gauges_[gauge];
  const double value = observed.gauges[gauge];
  const bool is_enough = elite.size() < kElite || value > std::prev(elite.end())->first;
  return value > 0 && is_enough && !elite.contains(value);
}

void Elite::keep(std::size_t gauge, const Observation& observed, EntryId entry, Archive& archive) {
  auto& elite = of_gauges_[gauge];
  elite.emplace(observed.gauges[gauge], entry);
  archive.hold(entry);
  if (elite.size() <= kElite) return;
  const auto last = std::prev(elite.end());
  archive.let_go(last->second);
  elite.erase(last);
}

bool Elite::is_empty() const {
  return std::ranges::all_of(of_gauges_, [](const auto& of_gauge) { return of_gauge.empty(); });
}

std::vector<std::vector<EntryId>> Elite::by_gauge() const {
  std::vector<std::vector<EntryId>> all;
  for (const auto& of_gauge : of_gauges_) {
    if (of_gauge.empty()) continue;
    std::vector<EntryId>& entries = all.emplace_back();
    for (const auto& [value, entry] : of_gauge) entries.push_back(entry);
  }
  return all;
}

}  // namespace manifuzz
