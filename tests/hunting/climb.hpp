#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "collider/collider.hpp"
#include "hunting/observation.hpp"

namespace manifuzz::test {

/// A bound, and the shapes among which the greatest share of it is sought.
struct Summit {
  std::string_view name;
  Gauge gauge;
  bool is_round = false;  ///< of round shapes, else of polygons with sharp corners
};

/// Every summit of a collider: of what the penetration curve judges, positions have no shares.
std::vector<Summit> summits_of(const Declaration& declaration);

/// A case and the share of a bound that a right answer to it takes.
struct Height {
  double share = 0;
  PairCase pair;
};

/// What a climb came to: the highest of every bound, that of its summit and those that it passed;
/// and the first case that was answered wrong on the way.
struct Climbed {
  std::array<Height, kGauges> highest;
  std::optional<PairCase> wrong;

  const Height& operator[](Gauge gauge) const { return highest[static_cast<std::size_t>(gauge)]; }
};

/// Climbs towards a summit: each of so many cases is bred from the highest yet, and takes its place
/// where it is as high or higher. Of three climbs one begins with the best of some drawn cases, one
/// with those of them whose rotations are unit but for rounding, where it stays, and one with one
/// of the `founders`. It keeps no archive and asks no oracle, so it breeds several times as many
/// cases in a second as a hunt does; what it finds is for a hunt to begin with. A function of its
/// arguments alone.
Climbed climb(const Summit& summit, const Collider& collider, std::span<const PairCase> founders,
              std::uint64_t seed, std::uint64_t index, std::uint64_t cases);

}  // namespace manifuzz::test
