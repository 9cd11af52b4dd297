#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/text.hpp"
#include "campaign/named_colliders.hpp"
#include "collider/collider.hpp"
#include "engines/colliders.hpp"
#include "external/external_collider.hpp"

namespace manifuzz {

/// How a collider is named on the command line.
struct ColliderChoice {
  std::string role;     ///< the option's name without its dashes: subject, oracle, collider
  std::string name;     ///< one of `list colliders`, or a shared library; empty: none was named
  std::string command;  ///< or a program
  bool keeps_points = false;  ///< the program does: it gets sequences
  bool is_chosen = false;     ///< on the command line, not taken by default

  bool is_given() const { return !name.empty() || !command.empty(); }
};

/// How libraries and programs are asked.
struct ExternalOptions {
  bool in_process = false;
  std::optional<double> time_limit;
  double start_seconds = kStartSecondsMax;  ///< what a program may take to say anything at all
  NamedSubjects named{};                    ///< colliders that cases name, as subjects.json says
};

/// The collider under test and the one it is held against.
struct SubjectAndOracle {
  ColliderChoice subject{"subject", "clip", ""};
  ColliderChoice oracle{"oracle", std::string(usual_oracle_name()), ""};
  ExternalOptions external;
};

/// Adds --ROLE and --ROLE-command; `choice.name` is the one that is taken where none is given.
void add_collider(CLI::App& app, ColliderChoice& choice, const std::string& description);
/// Adds --sequences, which says that the program keeps points.
void add_sequences(CLI::App& app, ColliderChoice& choice);
/// Adds --in-process and --time-limit.
void add_external_options(CLI::App& app, ExternalOptions& external);
/// Adds --subjects.
void add_subjects(CLI::App& app, std::string& file);
/// Adds --ROLE, --ROLE-command and the external options of both.
void add_subject_and_oracle(CLI::App& app, SubjectAndOracle& colliders);

/// The collider of that choice, with the tie bias where one is given. Throws UserError that says
/// what there is instead, or what is wrong with a library or a program.
Collider find_collider(const ColliderChoice& choice, const ExternalOptions& external,
                       std::optional<double> tie_bias = {});

/// The same, or nothing where none was named.
std::optional<Collider> given_collider(const ColliderChoice& choice,
                                       const ExternalOptions& external);

/// How the collider of that name is asked, as a file subjects.json says; nothing where none does.
std::optional<ColliderChoice> named_choice(const ColliderChoice& by_name,
                                           const NamedSubjects& subjects);
/// That collider. Throws UserError that begins with subjects.json; also where it declares another
/// name.
Collider find_named(const ColliderChoice& choice, const std::string& name,
                    const ExternalOptions& external);

/// Fails where it declares another name.
void expect_name(const Declaration& declaration, const std::string& name);
/// What `find` gives that subjects.json calls by that name, of pair cases or sequences. Throws
/// UserError that begins with subjects.json; also where it declares another name.
template <class Find>
auto find_by_its_name(const std::string& name, const Find& find) {
  try {
    auto found = find();
    expect_name(found.declaration, name);
    return found;
  } catch (const UserError& error) {
    throw UserError("subjects.json: " + printable(name) + ": " + error.what());
  }
}

/// The installed collider of a name, or what a file subjects.json gives that name; what is wrong
/// with that is an error line.
NamedColliders::Find find_installed_or_named(const NamedSubjects& subjects);

/// The seconds that a library or a program may take over a case. Throws UserError.
double time_limit_of(const ExternalOptions& external);

/// The options that choose the same colliders, or one collider, again, for a shell.
std::string options_again(const SubjectAndOracle& colliders);
std::string options_again(const ColliderChoice& choice, const ExternalOptions& external);
/// As above, with a space before them; empty where a case's own record of its colliders is enough.
std::string options_to_show(const SubjectAndOracle& colliders);

}  // namespace manifuzz
