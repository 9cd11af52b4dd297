#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "collider/collider.hpp"

namespace manifuzz {

struct ColliderEntry {
  std::string_view name;
  std::function<Collider()> make;
  bool is_ours = false;  ///< of this repository, not one that it is held against
};

/// Why an engine is not there: one line for people.
std::string left_out(std::string_view name, std::string_view package);

/// The colliders that are built in, or linked where they are installed; adapters are left out.
const std::vector<ColliderEntry>& linked_colliders();

/// Every collider there is, in the order of `list colliders`.
const std::vector<ColliderEntry>& colliders();

/// The entry of that name, or nullptr.
const ColliderEntry* find_entry(std::string_view name);

/// The collider of that name; nothing where there is none, or where it is not installed.
std::optional<Collider> find_installed(const std::string& name);

/// The collider of that name, or perturbed+NAME over another that gives points. Throws UserError
/// that lists the names.
Collider find_collider(std::string_view name);

/// What PREFIX+NAME is made over, the collider NAME, where `name` begins with `prefix`. Throws
/// UserError where that does not give one point a pair, of shapes as they are.
std::optional<Collider> find_made_over(std::string_view prefix, std::string_view name);

}  // namespace manifuzz
