#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "collider/collider.hpp"

namespace manifuzz {

struct ColliderEntry {
  std::string_view name;
  Collider (*make)();
  bool is_ours = false;  ///< of this repository, not one that it is held against
};

/// Every collider there is, in the order of `list colliders`.
const std::vector<ColliderEntry>& colliders();

/// The entry of that name, or nullptr.
const ColliderEntry* find_entry(std::string_view name);

/// The collider of that name; nothing where there is none, or where it is not installed.
std::optional<Collider> find_installed(const std::string& name);

/// The collider of that name. Throws UserError that lists the names.
Collider find_collider(std::string_view name);

}  // namespace manifuzz
