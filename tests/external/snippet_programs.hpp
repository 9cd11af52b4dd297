#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "collider/collider.hpp"
#include "support/run_program.hpp"

// The programs that reports hold, run on every pair of kinds of shape that their collider takes.

namespace manifuzz::test {

/// What a collider's program prints of its answers.
struct Prints {
  int least_touching = 12;  ///< in so many of the pairs there is a contact
  bool has_count = true;    ///< how many points there are
  bool has_depths = true;   ///< how deep each is
};

/// Each program is written to a file of this name in a folder, where `links`, a file or folder
/// each, are linked to, and run by a shell: `command` has {file} for its place, {folder} for the
/// folder. What it prints must be what the collider answers.
void check_programs(const Collider& collider, const std::string& file, const std::string& command,
                    const Prints& prints = {}, const std::vector<std::string>& links = {});

/// What each of these programs prints, run as check_programs runs them.
std::vector<Outcome> run_each(const std::vector<std::string>& programs, const std::string& file,
                              const std::string& command,
                              const std::vector<std::string>& links = {});

/// How a language writes the programs of all pairs in one file, which is compiled once and told
/// which to run.
struct Language {
  std::string_view file;
  std::string_view top;     ///< how lines begin that stand once, above all programs; empty for none
  std::string_view main;    ///< how a program's function begins
  std::string_view run;     ///< in its place
  std::string_view space;   ///< that holds a program
  std::string_view begin;   ///< of the function that chooses
  std::string_view choose;  ///< with {} for which program
  std::string_view end;
};
extern const Language kCpp;
extern const Language kJava;
extern const Language kRust;

/// What each of these programs prints, run as check_at_once runs them.
std::vector<Outcome> run_at_once(const std::vector<std::string>& programs, const Language& language,
                                 const std::string& compile, const std::string& run);

/// As check_programs, all in one file. In both commands stand {file} and {folder}, and in `run` {}
/// for which program.
void check_at_once(const Collider& collider, const Language& language, const std::string& compile,
                   const std::string& run, const Prints& prints = {});

}  // namespace manifuzz::test
