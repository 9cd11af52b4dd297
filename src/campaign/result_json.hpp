#pragma once

#include <nlohmann/json.hpp>

#include "base/json.hpp"
#include "campaign/result.hpp"

namespace manifuzz {

/// What `fuzz --json` writes.
nlohmann::ordered_json json_of(const FuzzResult& result);

/// What was written so, each part checked, and against the others. Unknown keys are let be, for
/// they may be a later version's. Throws UserError that begins with a path.
FuzzResult read_fuzz_result(const JsonView& root);

}  // namespace manifuzz
