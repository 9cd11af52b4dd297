#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.hpp"
#include "engines/asked_engines.hpp"
#include "engines/colliders.hpp"
#include "support/skip.hpp"
#include "support/source_tree.hpp"

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

/// The collider of that name where its ledger is built too; otherwise the test is skipped.
inline std::optional<Collider> collider_with_ledger(std::string_view name) {
  if (!is_without_ledger(name)) return installed_collider(name);
  skip("ledgers of engines that are not built; MANIFUZZ_ENGINES=all scripts/test builds them");
  return std::nullopt;
}

/// A file in the folder of the engine that has that collider.
inline std::filesystem::path in_engine(std::string_view collider, std::string_view file) {
  return source_dir() / "oracle" / find_asked(collider)->engine->name / file;
}

}  // namespace manifuzz::test
