#pragma once

#include <span>
#include <string_view>

namespace manifuzz {

// What the build knows of the engines' folders; the build writes the source.

/// The texts in an engine's folder.
struct EngineText {
  std::string_view name;     ///< its folder's
  std::string_view json;     ///< engine.json
  std::string_view ledger;   ///< ledger.json; empty where it has none
  std::string_view budgets;  ///< budgets.json; likewise
};

/// In the order of oracle/engines.txt, whether built or not.
std::span<const EngineText> engine_texts();

/// The folder of the engines' folders, and that of the shared libraries which the build makes.
extern const std::string_view kEnginesFolder;
extern const std::string_view kBuiltLibraries;

}  // namespace manifuzz
