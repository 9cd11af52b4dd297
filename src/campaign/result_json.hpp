#pragma once

#include <nlohmann/json.hpp>

#include "base/json.hpp"
#include "campaign/result.hpp"

namespace manifuzz {

/// What `fuzz --json` writes.
nlohmann::ordered_json json_of(const CampaignResult& result);

/// What was written so: every part that is read has its type, and no case is counted twice; sums
/// are taken from the rows. Unknown keys are let be, for they may be a later version's. Throws
/// UserError that begins with a path.
CampaignResult read_campaign_result(const JsonView& root);

}  // namespace manifuzz
