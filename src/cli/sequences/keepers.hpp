#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/sequences/replay_sequence.hpp"
#include "cli/collider_choice.hpp"

namespace manifuzz {

// Colliders that keep points, as commands choose them: by the options of any other.

/// Whether that name is of one.
bool keeps_points(std::string_view name);
bool keeps_points(const ColliderChoice& choice);

/// The collider of that choice. Throws UserError where it keeps no points, or there is none.
SequenceCollider find_keeper(const ColliderChoice& choice, const ExternalOptions& external);

/// The one that is given, or else those that files name.
NamedKeepers named_keepers(const ColliderChoice& choice, const ExternalOptions& external);

/// The one that was asked for, else the one that the sequence names, else the usual one.
SequenceCollider keeper_for(const CorpusCase& given, ColliderChoice choice,
                            const ExternalOptions& external);

/// Fails where any of these options, which pair cases have alone, was given.
struct PairOption {
  std::string_view name;
  bool is_given = false;
};
void expect_none_of(const std::vector<PairOption>& options);

/// Sequences in, answers out, a line a frame.
int collide_sequences(const ColliderChoice& choice, const ExternalOptions& external,
                      const std::string& file);

/// Sequences in, a line a frame out; status 1 where something is wrong that nobody explains.
int judge_sequences(const ColliderChoice& choice, const ExternalOptions& external,
                    const std::string& file);

/// Sequences of these motions, a line each.
struct SequenceDraw {
  std::vector<std::string> names;
  std::optional<std::uint64_t> seed;
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};
int generate_sequences(const SequenceDraw& draw);

/// Whether a regime's name is a motion's.
bool names_motion(const std::vector<std::string>& names);

/// Fails where one is, and says who takes it.
void expect_no_motions(const std::vector<std::string>& names);

/// What of a corpus the subject takes, if one was named: pair cases or sequences, else both. Says
/// on stderr what is left out.
Corpus taken_by(const ColliderChoice& subject, Corpus corpus);

/// The text of a sequence and, where a file is named for it, its filmstrip.
int show_sequence(const CorpusCase& given, const ColliderChoice& choice,
                  const ExternalOptions& external, const std::string& picture);

}  // namespace manifuzz
