#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz::canary {

/// How a planted bug was caught.
struct Sighting {
  std::string by;      ///< what noticed: the judge of which collider, a property, the twin
  std::string regime;  ///< of the case
  std::uint64_t cases = 0;
  double seconds = 0;
  PairCase shrunk;
};

/// What notices a bug on a case: its name, or none.
using Notice = std::function<std::optional<std::string>(std::uint64_t number, const PairCase&)>;

/// The smallest case like one that was noticed.
using Shrink =
    std::function<PairCase(std::uint64_t number, const PairCase&, const std::string& by)>;

/// Cases of all regimes in turn, from a fixed seed, until one is noticed or so many are done.
std::optional<Sighting> search(const Notice& notice, const Shrink& shrink, std::uint64_t cases_max);

/// A bug's own search.
struct PlantedBug {
  std::string name;
  std::uint64_t cases_max = 0;  ///< within which it must be caught
  std::function<std::optional<Sighting>(std::uint64_t cases_max)> search;
};

/// Every planted bug, in the order of their registration.
std::vector<PlantedBug>& planted_bugs();

/// Adds a bug and registers a test that it is caught, or, of an unedited copy, that it is not. To
/// be called before main.
bool add_planted_bug(PlantedBug bug);

}  // namespace manifuzz::canary
