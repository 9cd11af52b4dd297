#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hunting/hunted_pairs.hpp"

namespace manifuzz {

/// What a hunt is to look for, and among what.
struct HuntPlan {
  Plan plan;  ///< its regimes are those that cases are drawn from
  std::vector<PairCase> founders;
  std::optional<Measure> measure;
  bool compares = true;                 ///< runs as many drawn cases, too
  std::string what{};                   ///< in words: hunts that may be added up say the same
  std::optional<Rounds> rounds{};       ///< of which the plan is one share
  std::vector<ArchivedCase> earlier{};  ///< of the rounds before, in the order of `best_of`
  std::string again{};                  ///< options that run a share again
  /// Is told of each hunted case and of each drawn one once it is judged, in the job's process.
  OnJudged on_hunted{};
  OnJudged on_drawn{};
};

/// The greatest of one gauge that a hunt met, and that as many drawn cases met.
struct WorstFound {
  Gauge gauge = Gauge::error;
  double value = 0;  ///< 0: none
  std::optional<PairCase> pair;
  CaseNumber number = 0;
  std::optional<double> drawn;  ///< none: nothing was drawn to compare with
  std::string file{};           ///< of a corpus, where it is kept; else empty
};

/// How far a hunt has come.
struct HuntProgress {
  const Plan& plan;  ///< of the hunted cases
  Progress cases;
  std::size_t cells = 0;
  std::optional<std::size_t> cells_drawn;
  double worst = 0;                ///< of the first measure that has any
  Gauge worst_of = Gauge::error;   ///< which that is
  std::size_t behaviours = 0;      ///< buckets that were met
  double behaviours_a_second = 0;  ///< new ones, lately
};
using OnHuntProgress = std::function<void(const HuntProgress&)>;

/// A hunt that was run. What it found wrong is a campaign's findings.
struct Hunt {
  Campaign campaign;
  std::size_t generations = 0;
  FilledCells cells;
  std::optional<FilledCells> cells_drawn;
  std::vector<WorstFound> worst;             ///< of each gauge of the measure
  std::vector<std::string> buckets_drawn{};  ///< of somebody's mistakes that drawn cases alone met
  std::string what{};                        ///< as the plan's
  std::optional<Rounds> rounds{};
  std::vector<ArchivedCase> archived{};  ///< of a share, in the order of their numbers
};

/// Runs the hunt until it is done or somebody asks to stop; saves as a campaign does.
Hunt run_hunt(const HuntPlan& hunt, const Known& known, const SaveTo& save_to, const Origin& origin,
              const OnHuntProgress& on_progress);

/// The campaign's result, with what only hunts have: a row for each measure, and one for each
/// bound.
CampaignResult result_of(const Hunt& hunt);

}  // namespace manifuzz
