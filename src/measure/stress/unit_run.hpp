#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <span>

#include "measure/stress/stress.hpp"

namespace manifuzz {

/// After so many lost cases a collider has lost the rest of its unit: crashes are slow.
inline constexpr std::size_t kLostMax = 20;

/// The cases at which a subject died or hung.
struct LostCases {
  std::array<std::uint64_t, kLostMax> cases{};
  std::size_t count = 0;
  /// It is not asked from here on, having died too often.
  std::uint64_t given_up_from = std::numeric_limits<std::uint64_t>::max();

  /// One that dies of what it answered before is not asked again: reruns would have no end.
  void add(std::uint64_t index);
  /// Whether the subject is not to be asked: it died of this case, or of too many before it.
  bool has(std::uint64_t index) const;
};

/// Nobody is being asked.
inline constexpr int kNobody = -1;

/// What is being done about a unit, in memory that a job shares with its parent.
struct UnitState {
  std::atomic<std::uint64_t> index{0};         ///< the case at work
  std::atomic<int> subject{kNobody};           ///< who is being asked
  std::atomic<std::uint64_t> progress{0};      ///< moves while anything does
  std::array<LostCases, kSubjectsMax> lost{};  ///< by subject
};

/// Runs a unit from its first case on, and tells `on_cases` of every block that is done; `tallies`
/// are the subjects'. False
/// where `go_on` said no before its end.
bool run_unit(const StressPlan& plan, const Unit& unit, UnitState& state,
              const std::function<bool()>& go_on,
              const std::function<void(std::uint64_t)>& on_cases,
              std::span<StepStatistics> tallies);

}  // namespace manifuzz
