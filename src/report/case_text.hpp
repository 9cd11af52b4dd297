#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "campaign/judged_case.hpp"
#include "judging/judge.hpp"

namespace manifuzz {

/// The case for a terminal: verdict, polygons, truth, bounds, candidate and answers. Numbers read
/// back bit for bit.
std::string case_text(const JudgedCase& judged);

/// Appends what `collide` prints of a case as one line of JSON, without its end: the collider's
/// manifold. Throws UserError where there is no answer, or numbers that JSON cannot write.
void append_collision(std::string& line, const Collider& collider, const PairCase& pair);

/// Appends what `judge` prints: what is right, by how much one may be off, verdict and bucket.
/// Lengths are in the world.
void append_judgement(std::string& line, const Admissible& right, const Judgement& judgement);

/// A case as its line has it.
nlohmann::ordered_json case_json(const PairCase& pair);

}  // namespace manifuzz
