#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign/replay.hpp"
#include "campaign/run.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// Known cases again, every property and a campaign, within so many seconds, however slow the
/// colliders.
struct SmokePlan {
  Collider subject;
  Collider oracle;
  Corpus known_cases;  ///< which are replayed
  Corpus corpus{};     ///< of them, those that the regime `corpus` may mutate
  Known known{};       ///< of the known cases
  std::uint64_t seed = 0;
  std::string save_to{};  ///< a corpus folder; empty: nowhere
  Origin origin{};
  Clock::time_point start{};
  double seconds = 0;
  /// So long the colliders took to start, after `start`; the campaign's jobs start them once more.
  double start_seconds = 0;

  /// When the part must be done that has what is left, both starts aside, up to this share of it.
  Deadline at(double share, int starts) const;
  /// When the last picture must be drawn.
  Deadline end() const { return at(1, 2); }
};

/// What was done of it: where somebody asks to stop, no part is begun after that.
struct SmokeRun {
  std::vector<PairCase> pairs;  ///< the corpus's, of which the campaign may draw its cases again
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

/// `all` is stopped by a signal in any part. The run refers to the plan's known cases.
SmokeRun run_smoke(const SmokePlan& plan, const SmokeListener& listener, Interruption& all);

}  // namespace manifuzz
