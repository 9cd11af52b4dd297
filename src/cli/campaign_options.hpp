#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "campaign/save.hpp"
#include "cli/collider_choice.hpp"
#include "corpus/corpus_folders.hpp"

namespace manifuzz {

/// What `fuzz` and `hunt` are told alike: who is asked about which pairs, for how long, and where
/// what is found goes.
struct CampaignOptions {
  SubjectAndOracle colliders{};
  std::optional<std::uint64_t> seed{};
  std::optional<std::uint64_t> cases{};
  std::optional<double> seconds{};
  std::optional<std::uint64_t> jobs{};
  std::vector<std::string> regimes{};
  std::optional<double> tie_bias{};
  std::optional<double> radius{};
  CorpusFolders folders{};
  std::optional<double> shrink_seconds{};
  std::string today{};
  std::string json{};
  std::string report{};
  bool is_verbose = false;
};

/// How long a run takes where nothing says when it ends.
inline constexpr double kSecondsUnsaid = 10;

/// Gives the plan its colliders, and the regimes and shapes that these take.
void plan_pairs(Plan& plan, const CampaignOptions& options);
/// So many worker processes, or one per core.
int jobs_of(const std::optional<std::uint64_t>& jobs);
SaveTo save_to_of(const CampaignOptions& options);
/// --tie-bias and --radius again, for a shell, each with the space before it.
std::string bias_and_radius_again(const CampaignOptions& options);

/// Adds --shrink-seconds and --today.
void add_shrinking(CLI::App& app, CampaignOptions& options);
CLI::Option* add_jobs(CLI::App& app, std::optional<std::uint64_t>& jobs);
/// Adds --regime, --tie-bias, --radius, --corpus, --found and --no-save.
void add_pairs_and_folders(CLI::App& app, CampaignOptions& options);
/// Adds --verbose, --json and --report; `about` is what the page is about.
void add_summaries(CLI::App& app, CampaignOptions& options, const std::string& about);

}  // namespace manifuzz
