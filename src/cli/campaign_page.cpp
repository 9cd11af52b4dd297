#include "cli/campaign_page.hpp"

#include <filesystem>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/result.hpp"
#include "cli/kinds.hpp"
#include "engines/colliders.hpp"
#include "report/outputs.hpp"
#include "report/page/page.hpp"

namespace manifuzz {
namespace {

/// What a corpus has between these colliders; other engines' deviations are not this campaign's.
Corpus of_campaign(Corpus corpus, const Plan& plan) {
  const auto is_of_another = [&](const CorpusCase& one) {
    if (!one.expect) return collider_of_hunted(one.path) != plan.subject.declaration.name;
    const std::string& other =
        one.expect->oracle.empty() ? one.expect->subject : one.expect->oracle;
    return other != plan.subject.declaration.name && other != plan.oracle.declaration.name;
  };
  std::erase_if(corpus.cases, is_of_another);
  std::erase_if(corpus.others, is_of_another);
  return corpus;
}

/// Where the page's cases lie: the one file, or the folders, which may hold fewer others than the
/// whole corpus does.
std::set<std::string> paths_again(const Corpus& shown) {
  std::set<std::string> paths;
  const std::vector<CorpusCase> cases = shown.all();
  for (const CorpusCase& one : cases) {
    const std::filesystem::path file(one.path);
    const bool is_alone = cases.size() == 1 && std::filesystem::is_regular_file(file);
    paths.insert(is_alone ? file : file.parent_path());
  }
  return paths;
}

}  // namespace

std::string page_of_campaign(const Campaign& campaign, const nlohmann::ordered_json& summary,
                             const CampaignPage& options) {
  const bool is_kept = !options.json.empty() && options.json != "-";
  const std::string run = is_kept ? kept_path(options.json).string() : "this run";
  const RunFiles files{of_campaign(read_whole(options.folders), campaign.plan),
                       {{run, "fuzz", summary, campaign.result}}};
  const PageColliders colliders{
      {find_installed, campaign.plan.subject, campaign.plan.oracle},
      trials_of_others(options.colliders.subject, options.colliders.external)};
  const std::string program = this_program();
  std::string again = is_kept ? fmt::format("{} report", program) : "";
  if (is_kept) {
    for (const std::string& path : paths_again(files.corpus)) {
      again += ' ' + quoted_for_shell(path);
    }
    again += ' ' + quoted_for_shell(run);
  }
  return page_of(files, colliders, kMapsUsual, {program, again});
}

}  // namespace manifuzz
