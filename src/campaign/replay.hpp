#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/known.hpp"
#include "campaign/trial.hpp"
#include "collider/collider.hpp"
#include "corpus/corpus.hpp"
#include "process/interruption.hpp"
#include "properties/properties.hpp"

namespace manifuzz {

/// How to run a property: by RapidCheck, on the project's generator and shrink tree.
struct PropertyPlan {
  std::uint64_t seed = 0;
  int cases = 1000;
  std::span<const PairCase> corpus;      ///< what the regime `corpus` may mutate
  std::string rc_params;                 ///< of a failure to repeat, as `reproduce` below has it
  Interruption* interruption = nullptr;  ///< once there is hurry, it leaves the rest out
};

struct PropertyResult {
  bool passed = false;
  int cases = 0;                    ///< that were asked about, before anything was shrunk
  int applied = 0;                  ///< of these, those to which it applies
  double magnitude = 0;             ///< of the failure, as a share of the size
  std::string report;               ///< what RapidCheck says: the distribution, or the failure
  std::optional<PairCase> failing;  ///< the smallest found, or the one that the collider died of
  std::string why;
  std::string reproduce;  ///< a value of RC_PARAMS that repeats the failure; empty: the seed does
};

/// Runs in a child process: a collider that dies or hangs fails the property. Throws UserError
/// where `rc_params` cannot be read.
PropertyResult run_property(const Property& property, const Collider& collider,
                            const PropertyPlan& plan);

struct Replayed {
  bool passed = false;
  std::string expected;  ///< for people, where it failed
  std::string got;
  bool is_accepted = false;     ///< it passed although the subject is wrong, as is accepted
  bool is_stale = false;        ///< it is accepted, and what was accepted did not come again
  bool is_unsupported = false;  ///< neither passed nor failed: a collider cannot take the case

  bool has_failed() const { return !passed && !is_unsupported; }
};

/// Runs a corpus case again. It passes when the subject is right, or wrong as recorded and
/// accepted. Where the recorded pair of colliders runs, the recorded verdict and bucket must come
/// out too, unless they were against the subject: that it is right now is what a regression waits
/// for. A case that a property failed on must pass that property. One that either cannot take is no
/// failure, unless these two were recorded to answer it.
Replayed replay_case(const CorpusCase& recorded, const Trial& trial, const Known& known,
                     Interruption& interruption);

/// A corpus case that was run again.
struct ReplayedCase {
  const CorpusCase* recorded = nullptr;
  Replayed result;
  double seconds = 0;
  std::shared_ptr<const Trial> trial{};
};

struct ReplayRun {
  std::string subject;  ///< several names, where files name several
  std::string oracle;
  std::vector<ReplayedCase> cases;
  double seconds = 0;
  std::size_t left_out = 0;                  ///< cases that were not run, since it was time to stop
  std::vector<const CorpusCase*> unasked{};  ///< there is no subject of the name that they have

  std::size_t failed() const;
  std::size_t unsupported() const;
  std::size_t passed() const { return cases.size() - failed() - unsupported(); }
  std::size_t accepted() const;
  std::vector<std::string> stale() const;
  std::vector<Declaration> declarations() const;  ///< of all that were asked, each once, by name
  /// Adds another run.
  void add(const ReplayRun& run);
};

/// Every case again, as far as there is time; the run refers to the cases.
ReplayRun replay_cases(const std::vector<CorpusCase>& cases, const TrialOf& trial_of,
                       const Known& known, Interruption& interruption);

/// A property that was run over a collider.
struct CheckedProperty {
  const Property* property = nullptr;
  PropertyResult result;
  double seconds = 0;
  std::string saved{};        ///< the file its failing case was written to, or empty
  std::string why_unsaved{};  ///< why it could not be
  bool is_accepted = false;   ///< it fails, no worse than the corpus accepts
  std::string objection{};    ///< why not, where the corpus accepts less
  /// The names and options by which a hunt has it again; else its name does.
  std::string hunted_by{};

  bool holds() const { return result.passed || is_accepted; }
  std::string names_again() const {
    return hunted_by.empty() ? std::string(property->name) : hunted_by;
  }
  /// Whether there was no time for a single case.
  bool is_left_out() const { return result.passed && result.cases == 0; }
  /// Whether it passes because it said something of no case: the collider does not offer what it
  /// takes, perhaps.
  bool is_vacuous() const { return result.passed && result.cases > 0 && result.applied == 0; }
};

/// Every one of these properties, until somebody asks to stop or, each with its share of what time
/// is left, until the deadline; failing cases go to the folder `save_to`, unless it is empty.
/// `on_checked` runs after each.
std::vector<CheckedProperty> check_properties(
    const std::vector<const Property*>& chosen, const Collider& subject, const PropertyPlan& plan,
    const Known& known, const Deadline& deadline, const std::string& save_to,
    const std::function<void(const CheckedProperty&)>& on_checked);

}  // namespace manifuzz
