#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace manifuzz {

/// How a case is named on the command line.
struct CaseArgument {
  std::string name;               ///< a file, "-" for stdin, or what case_file looks up
  std::string corpus = "corpus";  ///< where it is looked up
};

/// Adds the argument, and --corpus.
void add_case_argument(CLI::App& app, CaseArgument& argument);

/// The file that is meant: the name itself where it is "-" or exists. Else it is looked up in the
/// corpus, as a bucket (with slashes or dashes), whose smallest case it is then, or as the
/// beginning of a file's name; what was taken is said on stderr. Throws UserError where that gives
/// no case, or several.
std::string case_file(const CaseArgument& argument);

}  // namespace manifuzz
