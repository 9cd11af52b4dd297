#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/text.hpp"
#include "cli/colliders.hpp"
#include "support/skip.hpp"
#include "support/source_tree.hpp"

namespace manifuzz::test {

/// The collider of that name. Where it is an engine of npm's that is not installed, nothing: the
/// test is skipped.
inline std::optional<Collider> installed_collider(std::string_view name) {
  try {
    return find_collider(name);
  } catch (const UserError& error) {
    const auto adapter = source_dir() / "scripts/colliders" / (std::string(name) + ".mjs");
    if (!std::filesystem::exists(adapter)) throw;
    skip(error.what());
    return std::nullopt;
  }
}

}  // namespace manifuzz::test
