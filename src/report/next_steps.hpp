#pragma once

#include <functional>
#include <string>

namespace manifuzz {

/// Whether the collider of that name is there on any machine.
using IsAtHand = std::function<bool(const std::string& collider)>;

/// What somebody new can do next, in about a dozen lines: commands that work when pasted where they
/// are, and a case of `corpus` to look at, where there is such a folder. `program` is this one as
/// it was called.
std::string next_steps(const std::string& program, const std::string& corpus,
                       const IsAtHand& is_at_hand);

}  // namespace manifuzz
