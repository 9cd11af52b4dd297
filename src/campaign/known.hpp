#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {

struct CampaignResult;

/// What a finding is one of: its bucket and who is at fault, or the property that failed and whose
/// it was. Ties count whoever the colliders were.
std::string finding_key(const Expectation& expect);
std::string finding_key(std::string_view property, std::string_view subject);

/// What findings of one kind of the same collider have in common; where both are wrong, of the
/// subject.
std::string kind_key(const Bucket& bucket, std::string_view subject, std::string_view oracle);

/// An acceptance, and the file that it stands in.
struct Accepted {
  Acceptance acceptance;
  std::string file;
};

/// What is known of findings before a run, by their keys: those that a corpus shows, those that it
/// accepts, and the buckets of a baseline.
struct Known {
  std::map<std::string, std::string> files;
  std::map<std::string, Accepted> accepted;  ///< of several, the one that accepts most
  std::map<std::string, WorstError> worst;   ///< the greatest of what files tell of
  /// What is accepted of all buckets of a kind together, by `kind_key`.
  std::map<std::string, Acceptance> kinds;
  std::set<std::string> baseline;  ///< the keys of its buckets
  std::string today;               ///< until which days acceptances hold
};
Known known_of(std::span<const CorpusCase> corpus, const std::string& today);

/// Adds an earlier run's buckets, if it was one of the plan's colliders: another's mistakes excuse
/// nobody.
void add_baseline(const CampaignResult& baseline, const Plan& plan, Known& known);

/// A finding, so wrong, beside what is known.
struct KnownAs {
  std::string file;  ///< of the corpus, where one shows it; else empty
  bool is_in_baseline = false;
  const Acceptance* acceptance = nullptr;  ///< what the corpus accepts of it, if anything
  std::string objection;                   ///< why it accepts less than that; else empty
  bool is_worst = false;                   ///< worse than is accepted and than any file tells of
  std::optional<Component> worst_in{};     ///< in this, if not in magnitude

  bool is_accepted() const { return acceptance != nullptr && objection.empty(); }
};
KnownAs known_as(const std::string& key, const WorstError& error, const Known& known);

/// Whether it is the recorded bucket, or one of its classes: older files name none, or no bucket.
bool is_bucket(const std::string& got, const std::string& recorded);

/// What keeps a finding that is so wrong from being accepted: it is worse, or the day is past;
/// empty where nothing does.
std::string objection(const Acceptance& acceptance, const WorstError& error,
                      const std::string& today);

/// Whether the case is accepted of these colliders, and another bucket came than was accepted.
bool is_stale(const CorpusCase& known, const std::string& got, const Collider& subject,
              const Collider& oracle);

/// A bucket that a campaign filled.
struct Finding {
  Bucket bucket;
  BucketTally tally;
  bool is_new = false;       ///< neither the corpus nor the baseline has its bucket
  std::string file;          ///< of the corpus, where one shows it; else empty
  bool is_accepted = false;  ///< no worse and no more often than the corpus accepts
  std::string objection{};   ///< of what is accepted in part: why not here
};

/// Every bucket of the tally but agree, in the order of `place_of`.
std::vector<Finding> findings(const Tally& tally, const Plan& plan, const Known& known);

/// Whether one of them is new.
bool has_new(std::span<const Finding> found);

/// Whether a case is what a campaign waits for: somebody's mistake, and neither the corpus shows
/// its bucket nor a baseline has it, or it is worse than is accepted.
bool is_new_and_wrong(const Judgement& judgement, const Plan& plan, const Known& known);

/// How often the campaign met it, in each regime.
Seen seen_of(const Finding& finding, const Tally& tally, const Plan& plan);

}  // namespace manifuzz
