#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "collider/collider.hpp"
#include "judging/properties.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// How to run a property: by RapidCheck, on the project's generator and shrink tree.
struct PropertyPlan {
  std::uint64_t seed = 0;
  int cases = 1000;
  std::span<const PairCase> corpus;      ///< what the regime `corpus` may mutate
  std::string rc_params;                 ///< of a failure to repeat, as `reproduce` below has it
  Interruption* interruption = nullptr;  ///< once there is hurry, it leaves the rest out
};

struct PropertyResult {
  bool passed = false;
  int cases = 0;                    ///< that were asked about, before anything was shrunk
  std::string report;               ///< what RapidCheck says: the distribution, or the failure
  std::optional<PairCase> failing;  ///< the smallest found, or the one that the collider died of
  std::string why;
  std::string reproduce;  ///< a value of RC_PARAMS that repeats the failure; empty: the seed does
};

/// Runs in a child process: a collider that dies or hangs fails the property. Throws UserError
/// where `rc_params` cannot be read.
PropertyResult run_property(const Property& property, const Collider& collider,
                            const PropertyPlan& plan);

}  // namespace manifuzz
