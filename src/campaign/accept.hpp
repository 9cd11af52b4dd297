#pragma once

#include <filesystem>
#include <string>

#include "corpus/corpus.hpp"

namespace manifuzz {

/// Whether both show the same kind of mistake of the same collider, or the same property of it that
/// fails.
bool is_of_same_kind(const CorpusCase& known, const CorpusCase& wanted);

/// What is asked for, completed from the case: its rates, and how much worse it may become. Throws
/// UserError where it is nobody's mistake.
Acceptance acceptance_of(const CorpusCase& known, Acceptance asked);

/// The case in this file, with that acceptance, which is not written yet. Throws UserError.
CorpusCase accepted_case(const std::string& file, const Acceptance& asked);

/// Writes its acceptance into its file; of a case that has no file of its own (a line, the standard
/// input) into one in the corpus, which `path` is then. Throws UserError.
void accept_in(const std::filesystem::path& corpus, CorpusCase& accepted);

/// Takes the acceptance out of the file. Throws UserError where it has none.
void drop_acceptance(const std::string& file);

/// "FILE: BUCKET of SUBJECT, up to ..., until ...: because ... (link)".
std::string acceptance_in_words(const CorpusCase& accepted, const std::string& today);

/// A line like that of each accepted case.
std::string list_accepted(const Corpus& known_cases, const std::string& today);

}  // namespace manifuzz
