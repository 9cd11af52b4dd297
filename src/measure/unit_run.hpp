#pragma once

#include <array>
#include <atomic>
#include <functional>

#include "measure/stress.hpp"

namespace manifuzz {

/// After so many lost cases a collider has lost the rest of its unit: crashes are slow.
inline constexpr std::size_t kLostMax = 20;

/// The cases at which contestants took their process along.
struct LostCases {
  std::array<std::array<std::uint64_t, kLostMax>, kContestantsMax> cases{};
  std::array<std::size_t, kContestantsMax> counts{};

  void add(std::size_t contestant, std::uint64_t index) {
    cases[contestant][counts[contestant]++] = index;
  }
  /// Whether the contestant is not to be asked: it died of this case, or of too many before it.
  bool has(std::size_t contestant, std::uint64_t index) const;
};

/// Nobody is being asked.
inline constexpr int kNobody = -1;

/// What a job is at, where its parent can see it.
struct UnitDesk {
  std::atomic<std::uint64_t> index{0};   ///< the case at work
  std::atomic<int> contestant{kNobody};  ///< who is being asked
  std::atomic<std::uint64_t> pulse{0};   ///< moves while anything does
  LostCases lost;
};

/// Runs a unit from its first case on, and tells `on_cases` of every block that is done. False
/// where `go_on` said no before its end.
bool run_unit(const StressPlan& plan, const Unit& unit, UnitDesk& desk,
              const std::function<bool()>& go_on,
              const std::function<void(std::uint64_t)>& on_cases, StepTally* tallies);

}  // namespace manifuzz
