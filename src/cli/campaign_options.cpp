#include "cli/campaign_options.hpp"

#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "cli/kinds.hpp"
#include "cli/options.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kJobsMax = 256;

}  // namespace

void plan_pairs(Plan& plan, const CampaignOptions& options) {
  const SubjectAndOracle& asked = options.colliders;
  plan.subject = find_collider(asked.subject, asked.external, options.tie_bias);
  plan.oracle = find_collider(asked.oracle, asked.external);
  expect_regimes_of_pairs(options.regimes);
  plan.regimes = regimes_for({plan.subject, plan.oracle}, options.regimes);
  if (options.radius) plan.context.radius = radius_of(*options.radius);
  narrow_to_colliders(plan);
}

int jobs_of(const std::optional<std::uint64_t>& jobs) {
  const std::uint64_t cores = std::max(1U, std::thread::hardware_concurrency());
  return static_cast<int>(jobs.value_or(cores));
}

SaveTo save_to_of(const CampaignOptions& options) {
  return {.folder = options.folders.save_to(),
          .shrink_seconds = options.shrink_seconds.value_or(kShrinkSeconds)};
}

std::string bias_and_radius_again(const CampaignOptions& options) {
  std::string again;
  if (options.tie_bias) again += fmt::format(" --tie-bias {}", *options.tie_bias);
  if (options.radius) again += fmt::format(" --radius {}", *options.radius);
  return again;
}

void add_shrinking(CLI::App& app, CampaignOptions& options) {
  add_length(app, "--shrink-seconds", options.shrink_seconds,
             "seconds to spend on shrinking all findings; default: 10");
  add_today(app, options.today);
}

CLI::Option* add_jobs(CLI::App& app, std::optional<std::uint64_t>& jobs) {
  return add_whole_number(app, "--jobs", jobs, "number of worker processes; default: one per core",
                          1, kJobsMax);
}

void add_pairs_and_folders(CLI::App& app, CampaignOptions& options) {
  add_regimes(app, options.regimes);
  add_length(app, "--tie-bias", options.tie_bias,
             "tie bias of the subject: how much greater the separation of B's face must be for B "
             "to become the reference");
  add_radius(app, options.radius);
  add_corpus(app, options.folders,
             "folder of known cases, in which new ones are saved; default: read corpus, and save "
             "new ones in build/found of the source tree, or in found outside of it");
  add_found(app, options.folders);
  add_no_save(app, options.folders);
}

void add_summaries(CLI::App& app, CampaignOptions& options, const std::string& about) {
  app.add_flag(
      "--verbose", options.is_verbose,
      "print tables of regimes, verdicts, causes and buckets in place of the short summary");
  add_json(app, options.json, "the summary");
  add_text(app, "--report", options.report, "FILE.html",
           fmt::format("write an HTML page about {} and its corpus; - is stdout", about));
}

}  // namespace manifuzz
