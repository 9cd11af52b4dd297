#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "campaign/run.hpp"

namespace manifuzz {

// What campaigns print, for people.

/// How findings are looked at again.
struct ShowAgain {
  std::string program;    ///< as it was called
  std::string options{};  ///< of colliders that a case cannot name, with the space before them
};

/// What a campaign found, in at most 24 lines: how many cases, who is wrong in how many and by
/// what causes, and what is new or unexplained, the most serious first.
std::string campaign_screen(const Campaign& campaign, const ShowAgain& show,
                            const std::optional<CampaignResult>& baseline = {});

/// All of it: regimes, verdicts (zeros too), findings with their commands, and what is new, worse
/// and gone against a baseline.
std::string summary_table(const Campaign& campaign,
                          const std::optional<CampaignResult>& baseline = {});

/// What decides the status, alone; nothing where all is well.
std::string objections(const Campaign& campaign);

/// Who was run on how many cases, at what rate; a line and its end.
std::string campaign_heading(const Campaign& campaign);

/// What became of the run as a whole where it is not what was asked for, hints, and what is left to
/// do; a line each, the most important first.
std::string remarks_on_campaign(const Campaign& campaign);

/// One line of a running campaign: cases, rate, verdicts that count, time left.
std::string progress_line(const Plan& plan, const Progress& progress);

/// How many cases a second that is; 0 where no time has passed.
double per_second(std::uint64_t cases, double seconds);

}  // namespace manifuzz
