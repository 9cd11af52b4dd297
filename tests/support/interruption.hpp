#pragma once

#include <string>
#include <vector>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

// Interruption by an event, not by a clock: a collider counts its cases and signals the program
// that asks it. Tests are the same however slow the machine.

namespace manifuzz::test {

/// Runs the built manifuzz so that the colliders below find it.
Outcome run_interruptible(const std::vector<std::string>& arguments);

/// Commands of colliders that run in programs of their own. Of all the programs that run one of
/// them, the first that is at its `nth` case (from 1 on) interrupts manifuzz by SIGINT, once,
/// before it answers that case; all go on answering. Only one of these in a folder.
std::string interrupting_clip(const TemporaryFolder& folder, int nth);   ///< answers as `clip` does
std::string interrupting_blind(const TemporaryFolder& folder, int nth);  ///< finds no contact

}  // namespace manifuzz::test
