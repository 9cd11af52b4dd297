#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "hunting/hunt.hpp"
#include "report/campaign_text.hpp"

namespace manifuzz {

// What hunts print, for people, and write.

/// One line of a running hunt: cases, rate, cells filled, the worst value, new behaviours.
std::string hunt_line(const HuntProgress& progress);

/// How many cells were filled, and the worst of each measure, beside drawing.
std::string hunt_rows(const Hunt& hunt);

/// That, and a campaign's short summary.
std::string hunt_screen(const Hunt& hunt, const ShowAgain& show);
/// That, and a campaign's tables.
std::string hunt_table(const Hunt& hunt);

nlohmann::ordered_json json_of(const Hunt& hunt);

}  // namespace manifuzz
