#pragma once

#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

#include "collider/collider.hpp"

namespace manifuzz {

/// What every measurement begins with: machine (processor, cores, the instruction set that the
/// kernels run on; no host name), compiler, seed, and the versions of manifuzz and of the colliders
/// that ran.
nlohmann::ordered_json provenance(std::uint64_t seed, const std::vector<Declaration>& colliders);

}  // namespace manifuzz
