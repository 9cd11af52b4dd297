#include "hunting/elite.hpp"

namespace manifuzz {
namespace {

/// So many of each gauge.
constexpr std::size_t kElite = 64;

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

std::vector<std::size_t> Elite::gauges_with_cases() const {
  std::vector<std::size_t> gauges;
  for (std::size_t gauge = 0; gauge < kGaugesMost; ++gauge) {
    if (!of_gauges_[gauge].empty()) gauges.push_back(gauge);
  }
  return gauges;
}

std::vector<EntryId> Elite::of(std::size_t gauge) const {
  std::vector<EntryId> entries;
  for (const auto& [value, entry] : of_gauges_[gauge]) {
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace manifuzz
