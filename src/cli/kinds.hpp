#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/plan.hpp"
#include "campaign/trial.hpp"
#include "cli/collider_choice.hpp"
#include "cli/drawn_cases.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {

/// A kind of cases beside pair cases: who is asked about them, and what commands do then. Each
/// throws UserError where the collider is none for them.
struct OtherKind {
  CaseKind kind = CaseKind::sequence;
  std::string_view noun;
  std::string_view regime_is;  ///< what a name is that is no regime of pairs, and what takes it
  bool (*is_asked)(const ColliderChoice& choice) = nullptr;
  bool (*has_regime)(std::string_view name) = nullptr;
  void (*plan)(Plan& plan, const SubjectAndOracle& asked,
               std::span<const std::string> regimes) = nullptr;
  /// By the collider that was asked for, else the one that the case names, else the usual one.
  std::shared_ptr<const Trial> (*trial)(const CorpusCase& given, ColliderChoice choice,
                                        const ExternalOptions& external) = nullptr;
  /// By the collider that was asked for, or else those that cases name.
  TrialOf (*trials)(const ColliderChoice& choice, const ExternalOptions& external) = nullptr;
  int (*collide)(const ColliderChoice& choice, const ExternalOptions& external,
                 const std::string& file) = nullptr;
  int (*judge)(const ColliderChoice& choice, const ExternalOptions& external,
               const std::string& file) = nullptr;
  int (*generate)(const DrawOptions& options) = nullptr;
  /// The text of a case and, where a file is named for it, its picture.
  int (*show)(const CorpusCase& given, const ColliderChoice& choice,
              const ExternalOptions& external, const std::string& picture) = nullptr;
};

// Each in a file of its own.
extern const OtherKind kSequences;

/// The kind that the collider is asked about, that a name among these is a regime of, that the case
/// is of; nullptr: pair cases.
const OtherKind* kind_for(const ColliderChoice& choice);
const OtherKind* kind_for(const std::vector<std::string>& regimes);
const OtherKind* kind_for(const AnyCase& any);

/// The kind of cases that a file must hold for this collider to be asked about it. A collider of
/// pairs may be given any file, since a case of another kind names its own collider.
CaseKind kind_to_read(const ColliderChoice& subject);

/// Fails where any of these options, which pair cases have alone, was given.
struct PairOption {
  std::string_view name;
  bool is_given = false;
};
void expect_none_of(const OtherKind& kind, const std::vector<PairOption>& options);

/// Fails where one is a regime of another kind, and says who takes it.
void expect_regimes_of_pairs(const std::vector<std::string>& names);
/// Fails where one is a regime of pair cases.
void expect_regimes_of(const OtherKind& kind, const std::vector<std::string>& names);

/// The trials of other kinds; of each kind, by the colliders that are installed or named.
TrialOf trials_of_others(const ColliderChoice& subject, const ExternalOptions& external);
TrialOf trials_of(const SubjectAndOracle& asked);

/// What of a corpus the subject takes, if one was named, else all. Says on stderr what is left out.
Corpus taken_by(const ColliderChoice& subject, Corpus corpus);

}  // namespace manifuzz
