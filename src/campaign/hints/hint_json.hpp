#pragma once

#include <nlohmann/json.hpp>

#include "base/json.hpp"
#include "campaign/hints/hint.hpp"

namespace manifuzz {

/// As `fuzz --json` has it.
nlohmann::ordered_json json_of(const Hint& hint);

/// Reads the same. Throws UserError that begins with a path.
Hint read_hint(const JsonView& row);

}  // namespace manifuzz
