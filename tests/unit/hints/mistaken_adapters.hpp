#pragma once

#include <string>
#include <vector>

#include "collider/collider.hpp"

// Right colliders behind adapters that ask or declare them wrongly.

namespace manifuzz::test {

struct MistakenAdapter {
  std::string mistake;  ///< the name that a hint is to give it
  std::string how;      ///< how the adapter makes it
  Collider collider;
};

/// Adapters whose mistake is in what they answer.
std::vector<MistakenAdapter> mistaken_in_answers();
/// Adapters whose mistake is in how they read the case, or in what they declare.
std::vector<MistakenAdapter> mistaken_in_reading();

/// The collider with answers that name neither reference nor features, as a program's may.
Collider without_names(const Collider& collider);

}  // namespace manifuzz::test
