#pragma once

#include <filesystem>
#include <string>

#include "corpus/corpus.hpp"

namespace manifuzz {

/// What is asked for, completed from the case: its rates, and how much worse it may become. Throws
/// UserError where it is nobody's mistake.
Acceptance acceptance_of(const CorpusCase& known, Acceptance asked);

/// The case in this file, with that acceptance, which is not written yet. Throws UserError.
CorpusCase accepted_case(const std::string& file, const Acceptance& asked);

/// Writes its acceptance into its file, and before that the case into the corpus where it is no
/// file of it; `path` is the file then. Throws UserError.
void accept_in(const std::filesystem::path& corpus, CorpusCase& accepted);

/// Takes the acceptance out of the file. Throws UserError where it has none.
void drop_acceptance(const std::string& file);

/// "FILE: BUCKET of SUBJECT, up to ..., until ...: because ... (link)".
std::string acceptance_in_words(const CorpusCase& accepted, const std::string& today);

/// The same of each case in the corpus that is accepted, a line each. Throws UserError.
std::string list_accepted(const std::filesystem::path& corpus, const std::string& today);

}  // namespace manifuzz
