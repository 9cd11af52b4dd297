#include "cli/commands.hpp"

namespace manifuzz {

extern const Command kCollide;
extern const Command kFuzz;
extern const Command kGenerate;
extern const Command kList;

std::span<const Command> commands() {
  static const Command all[] = {kFuzz, kCollide, kGenerate, kList};
  return all;
}

}  // namespace manifuzz
