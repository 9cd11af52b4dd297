#pragma once

#include <string>

namespace manifuzz {

/// What somebody new can do next, in about a dozen lines: commands that work when pasted where they
/// are, and a case of `corpus` to look at, where there is such a folder. `program` is this one as
/// it was called.
std::string next_steps(const std::string& program, const std::string& corpus);

}  // namespace manifuzz
