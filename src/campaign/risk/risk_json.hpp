#pragma once

#include <nlohmann/json.hpp>

#include "base/json.hpp"
#include "campaign/result.hpp"

namespace manifuzz {

/// What a result's JSON says of the risk: `risk`, a row for each regime and one for all, chances
/// from 0 to 1; `risk_error`, the chance that an interval misses; and `ended_by`, where the risk
/// was to end the campaign.
void add_risk(const CampaignResult& result, nlohmann::ordered_json& json);

/// Reads what of it the counts beside it do not give. Throws UserError that begins with a
/// path.
void read_risk(const JsonView& root, CampaignResult& result);

}  // namespace manifuzz
