#pragma once

#include <string>

#include "judging/judge.hpp"

namespace manifuzz {

/// Appends what `judge` prints of a case as one line of JSON, without its end: what is right, by
/// how much one may be off, verdict and bucket. Lengths are in the world.
void append_judgement(std::string& line, const Admissible& right, const Judgement& judgement);

}  // namespace manifuzz
