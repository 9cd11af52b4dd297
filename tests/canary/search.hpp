#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collider/collider.hpp"
#include "corpus/shrink.hpp"
#include "generating/regime.hpp"

namespace manifuzz::canary {

/// What noticed a bug on a case.
struct Noticed {
  std::string by;    ///< the judge of which collider, a property, the twin
  std::string look;  ///< the bucket; of a property its name
};

/// How a planted bug was caught.
struct Sighting {
  Noticed noticed;
  std::string regime;  ///< of the case
  std::uint64_t cases = 0;
  double seconds = 0;
  Shrunk shrunk;
  double shrink_seconds = 0;
};

using Notice = std::function<std::optional<Noticed>(std::uint64_t number, const PairCase&)>;

/// The smallest case like one that was noticed.
using Shrink = std::function<Shrunk(std::uint64_t number, const PairCase&, const Noticed&)>;

/// The cases of a seed: those of all regimes in turn, beginning with another regime for each seed.
struct Haystack {
  std::uint64_t seed = 0;
  std::uint64_t cases_max = 0;
  std::uint64_t first = 0;
  std::set<std::string> known_looks = {};  ///< passed over
  bool shrinks = true;                     ///< what is noticed; else it stays as it was drawn
  std::span<const Regime> regimes = manifuzz::regimes();  ///< in turn
};

/// Goes through the cases until one is noticed that looks like none known, or all are done.
std::optional<Sighting> search(const Haystack& haystack, const Notice& notice,
                               const Shrink& shrink);

/// A bug's own search.
struct PlantedBug {
  std::string name;
  std::uint64_t cases_max = 0;  ///< within which it must be caught
  std::function<std::optional<Sighting>(const Haystack&)> search;
  bool in_kernel = false;                   ///< told by promises, too, which are no buckets
  std::function<Collider()> collider = {};  ///< that has it, where it is a collider's
};

/// Whether it is a copy as it is, in which nothing may be noticed.
bool is_unedited(const PlantedBug& bug);

/// The most significant decimal digits of a number of the case.
int digits_of(PairCase pair);

/// Every planted bug, in the order of their registration.
std::vector<PlantedBug>& planted_bugs();

/// Adds a bug and registers a test that it is caught, or, of an unedited copy, that it is not. To
/// be called before main.
void add_planted_bug(PlantedBug bug);

}  // namespace manifuzz::canary
