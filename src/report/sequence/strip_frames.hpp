#pragma once

#include <cstddef>
#include <vector>

#include "campaign/sequences/sequence_case.hpp"

namespace manifuzz {

/// So many frames a filmstrip has at most.
inline constexpr std::size_t kStripMax = 8;

/// The frames that tell what happened, in order: all where they are few; else the one that decides
/// and its neighbours, where its point was born, the first, and births.
std::vector<std::size_t> frames_that_matter(const JudgedSequence& judged);

}  // namespace manifuzz
