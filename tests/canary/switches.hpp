#pragma once

#include <span>
#include <string>

#include "canary/edits.hpp"

namespace manifuzz::canary {

/// Whether the edit can be compiled into the clean code behind a switch, and chosen at run time
/// (mutant schemata: Untch, Offutt and Harrold 1993): its line is a statement, a variable's first
/// value or a condition, and so is what takes its place. All such bugs share one copy of the code,
/// which saves most of the time that they cost to compile.
bool fits_switch(const Edit& edit, const std::string& text);

/// The file's text with each of these edits behind a switch: while `is_acting(edit.line)`, it is
/// applied.
std::string switched(std::span<const Edit> edits, const std::string& text);

}  // namespace manifuzz::canary
