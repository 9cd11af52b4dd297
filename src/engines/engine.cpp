#include "engines/engine.hpp"

#include <algorithm>
#include <cassert>

#include "base/text.hpp"
#include "engines/engine_texts.hpp"

namespace manifuzz {

std::vector<BuiltLedger> built_ledgers() {
  std::vector<BuiltLedger> ledgers;
  for (const Engine& engine : built_engines()) {
    const EngineText* const text = find_by_name(engine_texts(), engine.name);
    ledgers.push_back({engine.ledger, text->budgets});
  }
  return ledgers;
}

std::vector<std::span<const SequenceEntry>> built_sequence_ledgers() {
  std::vector<std::span<const SequenceEntry>> ledgers;
  for (const Engine& engine : built_engines()) ledgers.push_back(engine.sequence_ledger);
  return ledgers;
}

const SceneBaseline& scene_baseline() {
  const auto has_scenes = [](const Engine& engine) { return engine.scenes.pairs != nullptr; };
  const auto found = std::ranges::find_if(built_engines(), has_scenes);
  assert(found != built_engines().end());
  return found->scenes;
}

}  // namespace manifuzz
