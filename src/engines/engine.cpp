#include "engines/engine.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace manifuzz {

std::vector<LedgerRow> rows_but_for(std::initializer_list<std::string_view> causes,
                                    std::span<const LedgerRow> rows) {
  std::vector<LedgerRow> others;
  assert(std::ranges::all_of(causes, [&](std::string_view cause) {
    return std::ranges::find(rows, cause, &LedgerRow::cause) != rows.end();
  }));
  std::ranges::copy_if(rows, std::back_inserter(others), [&](const LedgerRow& row) {
    return std::ranges::find(causes, row.cause) == causes.end();
  });
  return others;
}

const Engine& scene_engine() {
  const auto has_scenes = [](const Engine& engine) { return engine.scenes.pairs != nullptr; };
  const auto found = std::ranges::find_if(built_engines(), has_scenes);
  assert(found != built_engines().end());
  return *found;
}

}  // namespace manifuzz
