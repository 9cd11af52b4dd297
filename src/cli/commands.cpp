#include "cli/commands.hpp"

namespace manifuzz {

extern const Command kBench;
extern const Command kCollide;
extern const Command kFuzz;
extern const Command kGenerate;
extern const Command kJudge;
extern const Command kList;
extern const Command kMerge;
extern const Command kProperty;
extern const Command kReplay;
extern const Command kReport;
extern const Command kScene;
extern const Command kShow;
extern const Command kShrink;
extern const Command kSmoke;
extern const Command kStress;

std::span<const Command> commands() {
  static const Command all[] = {kFuzz,   kReplay,   kProperty, kSmoke, kCollide,
                                kJudge,  kGenerate, kShrink,   kShow,  kBench,
                                kStress, kScene,    kReport,   kMerge, kList};
  return all;
}

}  // namespace manifuzz
