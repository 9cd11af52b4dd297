#pragma once

#include <string>
#include <vector>

#include "campaign/judged_case.hpp"
#include "judging/neighbourhood.hpp"

namespace manifuzz {

/// The neighbourhood as a PNG file: what the subject says, what the oracle says, what is true and
/// the verdict, side by side, with the severity and a legend in words.
std::string map_png(const JudgedCase& judged, const Neighbourhood& neighbourhood);

/// A case's neighbourhood, drawn.
struct CaseMap {
  std::string png;                 ///< the file's bytes
  std::vector<std::string> words;  ///< what it is a map of, and its severity
};

/// Asks both about every neighbour, which lie `step_ulps` apart. Throws Interrupted.
CaseMap case_map(const JudgedCase& judged, const Collider& subject, const Collider& oracle,
                 int step_ulps, Interruption& interruption);

}  // namespace manifuzz
