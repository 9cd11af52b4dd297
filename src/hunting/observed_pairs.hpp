#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "campaign/pairs/pair_work.hpp"
#include "campaign/run.hpp"
#include "hunting/archive.hpp"
#include "hunting/observation.hpp"

namespace manifuzz {

/// Is told of a case once it is judged, in the job's process.
using OnJudged = std::function<void(CaseNumber number, const JudgedPair& judged)>;

/// The greatest of one gauge.
struct Worst {
  double value = 0;  ///< 0: none
  CaseNumber number = 0;
};
using WorstOfGauges = std::array<Worst, kGaugesMost>;

/// The regimes' pair cases, some at a time, of which an archive and the greatest of each gauge are
/// kept.
class ObservedPairs : public WorkOnPairs {
 public:
  /// At most so many at a time.
  ObservedPairs(CaseNumber most, Aim aim, OnJudged on_judged)
      : aim_(std::move(aim)), on_judged_(std::move(on_judged)), observations_(most) {}

  void learn(CaseNumber number, const JudgedPair& judged) const override;

  /// Makes room for what becomes of the cases that come next.
  void begin_part(SharedQueue::Block cases);
  /// Takes what became of them into the archive. Cases are made there if they are to be bred from.
  void end_part();

  FilledCells filled() const { return archive_.filled(); }
  const WorstOfGauges& worst() const { return worst_; }

 protected:
  /// The case of that number, for the archive; of cases that are only counted, an empty one.
  virtual PairCase to_keep(CaseNumber) const { return {}; }
  /// What became of a case that was run, and, if it is well posed, what it took of the archive.
  virtual void take_in(CaseNumber, const Observation&, const std::optional<Archive::Taken>&) {}

  /// Remembers, in the job's process, what became of a case of these.
  void note(CaseNumber number, const Observation& observed) const {
    observations_[number - cases_.begin] = observed;
  }

  const Aim& aim() const { return aim_; }
  Archive& archive() { return archive_; }
  const Archive& archive() const { return archive_; }
  const SharedQueue::Block& cases() const { return cases_; }

 private:
  Aim aim_;
  OnJudged on_judged_;
  Shared<Observation> observations_;
  SharedQueue::Block cases_;
  Archive archive_;
  WorstOfGauges worst_{};
};

}  // namespace manifuzz
