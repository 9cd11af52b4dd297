#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "campaign/known.hpp"
#include "campaign/replay.hpp"
#include "hunting/journal.hpp"
#include "hunting/property_checks.hpp"

namespace manifuzz {

/// What a hunt asks of each of its cases, and how many there are.
struct PropertyHuntPlan {
  std::vector<const Property*> properties;  ///< not empty
  Collider subject;
  std::span<const PairCase> corpus;  ///< what the regime `corpus` may mutate
  std::uint64_t seed = 0;
  std::uint64_t cases = 0;
  int jobs = 1;
  std::string save_to{};  ///< the findings' folder; empty: nothing is saved
};

/// How far it has come.
struct PropertyHuntProgress {
  std::uint64_t cases = 0;
  std::uint64_t of = 0;
  double seconds = 0;  ///< since the first answer
  std::size_t cells = 0;
  const std::vector<HuntedProperty>& hunted;  ///< until the last generation
};
using OnPropertyProgress = std::function<void(const PropertyHuntProgress&)>;

/// A hunt that was run.
struct PropertyHunt {
  std::vector<HuntedProperty> hunted;  ///< in the order of the plan
  std::uint64_t cases = 0;
  double seconds = 0;
  std::size_t generations = 0;
  std::size_t cells = 0;
  Journal journal;  ///< property-SEED.jsonl, until the failures are saved
};

/// Breeds cases, each by the seed and its number alone, and asks every property of each, until it
/// is done or somebody asks to stop.
PropertyHunt hunt_properties(const PropertyHuntPlan& plan, Interruption& interruption,
                             const OnPropertyProgress& on_progress);

/// What the hunt found, as `check_properties` gives what drawing found: the worst failure of each
/// property is shrunk, or, once somebody has asked to stop, left as it was seen, and saved.
std::vector<CheckedProperty> checked_by_hunt(
    const PropertyHunt& hunt, const PropertyHuntPlan& plan, const Known& known,
    Interruption& interruption, const std::function<void(const CheckedProperty&)>& on_checked);

}  // namespace manifuzz
