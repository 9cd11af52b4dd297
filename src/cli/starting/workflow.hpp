#pragma once

#include <string>

#include "cli/collider_choice.hpp"

namespace manifuzz {

/// Where a workflow gets manifuzz from.
struct CloneOf {
  std::string url;     ///< empty: a variable of the repository that the workflow runs in
  std::string commit;  ///< empty: the newest
};

/// The `origin` of the source tree that holds this program, unless that is a folder, and its
/// commit; what git does not tell is empty.
CloneOf clone_of_this_program();

/// What the workflow does besides.
struct WorkflowOf {
  ColliderChoice subject;
  std::string oracle;
  CloneOf manifuzz;
  std::string packages;  ///< of Debian, that the collider needs, with a space before each
  std::string build;     ///< the command that makes it, or empty
};

std::string workflow_text(const WorkflowOf& workflow);

}  // namespace manifuzz
