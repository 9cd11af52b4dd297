#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engines/engine.hpp"

namespace manifuzz {

/// This repository's own, and those of engines that the build links or makes: not what adapters
/// ask.
const std::vector<ColliderEntry>& linked_colliders();

/// Every collider there is, in the order of `list colliders`.
const std::vector<ColliderEntry>& colliders();

/// What is asked where no oracle is named: the first collider of the first engine.
Collider usual_oracle();
/// Its name.
std::string_view usual_oracle_name();

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
