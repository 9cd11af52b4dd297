#pragma once

#include <string>
#include <vector>

#include "campaign/judged_case.hpp"

namespace manifuzz {

/// A case's neighbourhood, drawn.
struct CaseMap {
  std::string png;                 ///< the file's bytes
  std::vector<std::string> words;  ///< what it is a map of, and its severity
};

/// Asks both about every neighbour, which lie `step_ulps` apart. Throws Interrupted.
CaseMap case_map(const JudgedCase& judged, const Collider& subject, const Collider& oracle,
                 int step_ulps, Interruption& interruption);

}  // namespace manifuzz
