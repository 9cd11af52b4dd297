#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/property_check.hpp"
#include "campaign/replay.hpp"
#include "campaign/run.hpp"

namespace manifuzz {

/// A corpus again, every property and a campaign, within so many seconds, however slow the
/// colliders.
struct SmokePlan {
  Collider subject;
  Collider oracle;
  Corpus corpus;
  std::uint64_t seed = 0;
  std::string save_to{};  ///< a corpus folder; empty: nowhere
  Origin origin{};
  Clock::time_point start{};
  double seconds = 0;

  /// When this share of the time is over.
  Deadline at(double share) const;
  /// When the last picture must be drawn.
  Deadline end() const { return at(1); }
};

/// What was done of it: where somebody asks to stop, no part is begun after that.
struct SmokeRun {
  ReplayRun replayed;
  std::vector<CheckedProperty> checked{};
  std::optional<Campaign> campaign{};

  bool is_well() const;
};

/// Whoever is told of each part once it is done.
struct SmokeListener {
  std::function<void(const ReplayRun&)> on_replayed;
  std::function<void(const CheckedProperty&)> on_checked;
  std::function<void(const Campaign&)> on_campaign;
  std::function<void(const Plan&, const Progress&)> on_progress;
};

/// `all` is stopped by a signal in any part. The run refers to the plan's corpus.
SmokeRun run_smoke(const SmokePlan& plan, const SmokeListener& listener, Interruption& all);

}  // namespace manifuzz
