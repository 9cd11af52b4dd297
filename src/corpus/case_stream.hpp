#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// Appends the line (without its end) that answers a case; throws UserError where there is none.
/// `index` counts the lines that are not blank, bad ones too, from 0.
using AnswerCase = std::function<void(const PairCase& pair, std::size_t index, std::string& line)>;

/// Reads cases from a file (*.json: one; else one a line, blank lines skipped; "-": stdin) and
/// writes a line for each to the standard output, in order and constant memory. A bad line gives
/// {"error":
/// "...", "line": N} in its place. Whoever feeds a pipe gets every answer before the next read.
/// Throws UserError at the end where a line was bad, or where there was no case.
void answer_each(const std::string& file, const AnswerCase& answer);

}  // namespace manifuzz
