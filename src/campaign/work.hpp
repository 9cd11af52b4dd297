#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/hints/hint.hpp"
#include "campaign/trial.hpp"

namespace manifuzz {

struct CampaignJob;
struct Plan;
struct CampaignRun;
struct Tally;

/// A position in the campaign's order of cases: case k is regime k % R at index first + k / R.
using CaseNumber = std::uint64_t;

/// A kind of cases, as a campaign runs them.
class KindOfWork {
 public:
  virtual ~KindOfWork() = default;
  KindOfWork& operator=(KindOfWork&&) = delete;  // neither moved nor copied

  virtual CaseKind kind() const = 0;
  /// What its cases are called where they are counted.
  virtual std::string_view noun() const = 0;
  virtual AnyCase draw(const Plan& plan, CaseNumber number) const = 0;
  virtual std::shared_ptr<const Trial> trial(const Plan& plan) const = 0;
  /// So many cases are handed out together, few enough that no job is left behind at the end.
  virtual std::uint64_t block_length() const = 0;
  /// What a job calls for each block that it has: it runs the block's cases, up to the run's end,
  /// and counts them.
  virtual std::function<void()> block_runner(const Plan& plan, CampaignRun& run,
                                             CampaignJob& job) const = 0;
  /// The options that run a case again, with a space before them.
  virtual std::string options_again(const Plan& plan, CaseNumber number) const;
  /// Whether its cases come as often as the ledger's budgets expect of their regimes.
  virtual bool has_budgets() const { return true; }
  /// Known mistakes of an adapter that make the wrong answers.
  virtual std::vector<Hint> hints(const Tally& tally, const Plan& plan,
                                  Interruption& interruption) const {
    (void)tally, (void)plan, (void)interruption;
    return {};
  }

 protected:
  KindOfWork() = default;
};

/// Pair cases of the plan's regimes, put to its subject and its oracle.
std::shared_ptr<const KindOfWork> work_on_pairs();

}  // namespace manifuzz
