#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "geometry/collider.hpp"

namespace manifuzz {

struct ColliderEntry {
  std::string_view name;
  Collider (*make)();
};

/// Every collider there is, in the order of `list colliders`.
const std::vector<ColliderEntry>& colliders();

/// The collider of that name, with the tie bias where one is given. Throws UserError that lists the
/// names, or says that this collider's bias is fixed.
Collider find_collider(std::string_view name, std::optional<double> tie_bias = {});

}  // namespace manifuzz
