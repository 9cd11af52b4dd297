#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "collider/collider.hpp"
#include "oracle/external/command.hpp"

namespace manifuzz {

/// How a collider is named on the command line.
struct ColliderChoice {
  std::string role;     ///< the option's name without its dashes: subject, oracle, collider
  std::string name;     ///< one of `list colliders`, or a shared library; empty: none was named
  std::string command;  ///< or a program
};

/// How those outside are asked.
struct ExternalOptions {
  bool in_process = false;
  std::optional<double> time_limit;
  double start_seconds = kStartSecondsMax;  ///< what a program may take to say anything at all
};

/// Adds --ROLE and --ROLE-command; `choice.name` is the one that is taken where none is given.
void add_collider(CLI::App& app, ColliderChoice& choice, const std::string& description);
/// Adds --in-process and --time-limit.
void add_external_options(CLI::App& app, ExternalOptions& outside);

/// The two parties of a comparison, clip against box2d unless others are given.
struct ComparedColliders {
  ColliderChoice subject{"subject", "clip", ""};
  ColliderChoice oracle{"oracle", "box2d", ""};
  ExternalOptions outside;
};
void add_compared_colliders(CLI::App& app, ComparedColliders& parties);

/// The collider of that choice, with the tie bias where one is given. Throws UserError that says
/// what there is instead, or what is wrong with a library or a program.
Collider find_collider(const ColliderChoice& choice, const ExternalOptions& outside,
                       std::optional<double> tie_bias = {});
inline Collider find_subject(const ComparedColliders& parties,
                             std::optional<double> tie_bias = {}) {
  return find_collider(parties.subject, parties.outside, tie_bias);
}
inline Collider find_oracle(const ComparedColliders& parties) {
  return find_collider(parties.oracle, parties.outside);
}

/// Whether that names a collider in `list colliders` or a shared library.
bool is_findable(const std::string& name);

/// The options that choose the same parties, or one collider, again, for a shell.
std::string options_again(const ComparedColliders& parties);
std::string options_again(const ColliderChoice& choice, const ExternalOptions& outside);

/// This program as it can be called again, relative to the working folder, so that a kept output
/// holds no absolute path; for a shell.
std::string this_program();

}  // namespace manifuzz
