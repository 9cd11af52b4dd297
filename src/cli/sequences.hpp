#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/trial.hpp"
#include "cli/collider_choice.hpp"
#include "collider/sequence_collider.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {

// Sequences and the colliders that keep points over their frames, as commands have them beside pair
// cases.

/// Whether the collider that was asked for keeps points: it is asked about sequences.
bool keeps_points(const ColliderChoice& choice);

/// Whether any of these names, which may be regimes of pair cases, is a motion.
bool any_motion(const std::vector<std::string>& names);

/// Which cases a file may hold that the collider is asked about: sequences, or any where it is
/// asked about pairs, since a file names its own.
CaseKind kind_to_read(const ColliderChoice& subject);

/// Fails where any of these options, which pair cases have alone, was given.
struct PairOption {
  std::string_view name;
  bool is_given = false;
};
void expect_none_of(const std::vector<PairOption>& options);

/// Fails where one is a motion, and says who takes it.
void expect_regimes_of_pairs(const std::vector<std::string>& names);
/// Fails where one is a regime of pair cases.
void expect_motions(const std::vector<std::string>& names);

/// The collider of that choice. Throws UserError where it keeps no points.
SequenceCollider find_keeper(const ColliderChoice& choice, const ExternalOptions& external);
/// The one that was asked for, else the one that the sequence names, else the usual one.
SequenceCollider keeper_for(const CorpusCase& given, ColliderChoice choice,
                            const ExternalOptions& external);

/// The trials of sequences, by the collider that was asked for, or else those that they name.
TrialOf trials_of_sequences(const ColliderChoice& subject, const ExternalOptions& external);
/// The trials of each kind, where pair cases find their colliders by `find`.
TrialOf trials_of(const SubjectAndOracle& asked, const NamedColliders::Find& find);

/// What of a corpus the subject takes, if one was named, else all. Says on stderr what is left out.
Corpus taken_by(const ColliderChoice& subject, Corpus corpus);

/// Reads sequences from a file and writes a line for each frame: the points that are kept.
void collide_sequences(const SequenceCollider& keeper, const std::string& file);
/// Reads sequences from a file and writes a line for each: what is right, and who is. Whether
/// something is wrong that nobody explains.
bool judge_sequences(const SequenceCollider& keeper, const std::string& file);
/// Writes the text of a sequence and, where a file is named for it, its picture.
void show_sequence(const CorpusCase& given, const SequenceCollider& keeper,
                   const std::string& picture);

}  // namespace manifuzz
