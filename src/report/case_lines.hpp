#pragma once

#include <string>

#include "judging/judge.hpp"

namespace manifuzz {

/// Appends what `collide` prints of a case as one line of JSON, without its end: the collider's
/// manifold. Throws UserError where there is no answer, or numbers that JSON cannot write.
void append_collision(std::string& line, const Collider& collider, const PairCase& pair);

/// Appends what `judge` prints: what is right, by how much one may be off, verdict and bucket.
/// Lengths are in the world.
void append_judgement(std::string& line, const Admissible& right, const Judgement& judgement);

}  // namespace manifuzz
