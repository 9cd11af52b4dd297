#pragma once

#include <optional>
#include <string_view>

#include "base/text.hpp"
#include "engines/colliders.hpp"
#include "support/skip.hpp"

namespace manifuzz::test {

/// The collider of that name. Where it is an engine that scripts/setup installs, and that is not
/// there, nothing: the test is skipped.
inline std::optional<Collider> installed_collider(std::string_view name) {
  try {
    return find_collider(name);
  } catch (const UserError& error) {
    if (std::string_view(error.what()).find("scripts/setup") == std::string_view::npos) throw;
    skip(error.what());
    return std::nullopt;
  }
}

}  // namespace manifuzz::test
