#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace manifuzz {

/// How a case is named on the command line.
struct CaseArgument {
  std::string name;  ///< a file, "-" for stdin, or what is looked up in the corpus
  std::string corpus = "corpus";
};

/// Adds the argument, and --corpus.
void add_case_argument(CLI::App& app, CaseArgument& argument);

/// The file that is meant; what was taken from the corpus is said on stderr. Throws UserError.
std::string case_file(const CaseArgument& argument);

}  // namespace manifuzz
