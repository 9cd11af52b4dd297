#pragma once

#include <filesystem>

#include "campaign/known.hpp"
#include "campaign/sequences/sequence_case.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {

/// The corpus case of a sequence as a collider that keeps points sees it: verdict and a note.
CorpusCase recorded_sequence(const Sequence& sequence, const SequenceJudgement& judgement,
                             const SequenceCollider& subject);

/// The finding's worst witness as the campaign saw it, without asking anybody.
CorpusCase unasked_sequence(const Finding& finding, const Plan& plan);

/// Shrinks the finding's worst witness and writes it to the corpus, and beside it the worst as it
/// was seen; sets the finding's file. Whether it is as small as can be. Throws UserError where it
/// cannot be written, and Interrupted.
bool save_sequence(Finding& finding, const Found& found, const Plan& plan,
                   const std::filesystem::path& corpus, const Deadline& deadline,
                   Interruption& interruption);

/// The smallest sequence that is the same finding, as a corpus has it. Throws UserError where there
/// is none, and Interrupted.
CorpusCase shrunk_sequence(const CorpusCase& given, const SequenceCollider& subject,
                           Interruption& interruption);

}  // namespace manifuzz
