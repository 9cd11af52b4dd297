#pragma once

#include <string>

namespace manifuzz {

/// What there is, a line each, with its description.
std::string list_regimes();
std::string list_sweeps();
std::string list_scenes();
std::string list_ledger();

}  // namespace manifuzz
