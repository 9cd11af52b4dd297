#include "report/lists.hpp"

#include <fmt/format.h>

#include "generating/regime.hpp"
#include "generating/sweep.hpp"
#include "generating/walk.hpp"
#include "judging/ledger.hpp"
#include "measure/scene/trajectory.hpp"

namespace manifuzz {

std::string list_regimes() {
  std::string lines;
  for (const Regime& regime : regimes()) {
    lines += fmt::format("{:<16} {}\n", regime.name, regime.description);
  }
  return lines;
}

std::string list_sweeps() {
  std::string lines;
  for (const Sweep& sweep : sweeps()) {
    lines += fmt::format("{:<10} {}: {} ({}), {:g} to {:g} in {} steps\n", sweep.name,
                         sweep.description, sweep.knob, sweep.unit, sweep.values.front(),
                         sweep.values.back(), sweep.values.size());
  }
  for (const Walk& walk : walks()) {
    lines += fmt::format("{:<10} {}\n", walk.name, walk.description);
  }
  return lines;
}

std::string list_scenes() {
  std::string lines;
  for (const SceneSpec& spec : scene_specs()) {
    lines += fmt::format("{:<14} {}\n", spec.name, spec.sentence);
  }
  return lines;
}

std::string list_ledger() {
  std::string lines;
  for (const LedgerEntry& entry : ledger()) {
    lines += fmt::format("{:<34} {} [{}; witness corpus/{}]\n", entry.id, entry.description,
                         entry.source, entry.witness);
  }
  return lines;
}

}  // namespace manifuzz
