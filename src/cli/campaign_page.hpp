#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "campaign/run.hpp"
#include "cli/collider_choice.hpp"
#include "corpus/corpus_folders.hpp"

namespace manifuzz {

/// Whose page it is, and where what it shows lies.
struct CampaignPage {
  SubjectAndOracle colliders;
  CorpusFolders folders;
  std::string json;  ///< the file of the summary; empty: none
};

/// The page of this campaign, and of what was found before between its colliders; `summary` is its
/// JSON.
std::string page_of_campaign(const Campaign& campaign, const nlohmann::ordered_json& summary,
                             const CampaignPage& options);

}  // namespace manifuzz
