#include "cli/collider_choice.hpp"

#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "cli/options.hpp"
#include "engines/asked_engines.hpp"
#include "engines/colliders.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

constexpr double kTimeLimit = 1;
constexpr double kTimeLimitMax = 3600;

bool is_library(const std::string& name) {
  return name.find('/') != std::string::npos || name.ends_with(".so");
}

/// An engine that runs in a process of its own has its own limit, unless another is asked for.
Collider find_within(const std::string& name, std::optional<double> seconds_max) {
  const auto found = seconds_max ? find_asked(name) : std::nullopt;
  if (!found || found->asked->is_linked || found->asked->keeps_points) return find_collider(name);
  EngineCollider asked = *found->asked;
  asked.seconds_max = *seconds_max;
  return collider_of(*found->engine, asked);
}

Collider find_any(const ColliderChoice& choice, const ExternalOptions& external) {
  const double seconds = time_limit_of(external);
  if (external.in_process && external.time_limit) {
    throw UserError(
        "--time-limit: applies only to colliders in their own processes; omit --in-process");
  }
  if (!choice.command.empty() && external.in_process) {
    throw UserError(
        fmt::format("--in-process: a program cannot run in this process; give a shared "
                    "library to --{}",
                    choice.role));
  }
  if (!choice.command.empty()) {
    return collider_of_command(choice.command, seconds, external.start_seconds);
  }
  if (!is_library(choice.name)) return find_within(choice.name, external.time_limit);
  return external.in_process ? collider_in_process(choice.name)
                             : collider_in_own_process(choice.name, seconds);
}

Collider with_tie_bias(const Collider& collider, double tie_bias) {
  if (!collider.with_tie_bias) {
    throw UserError(fmt::format("--tie-bias: {} has a fixed tie bias, {}; omit the option",
                                collider.declaration.name,
                                in_words(collider.declaration.tie_bias)));
  }
  if (tie_bias > static_cast<double>(std::numeric_limits<float>::max())) {
    throw UserError(fmt::format("--tie-bias: {:g} is too large for a float; use 0 to {:g}",
                                tie_bias, std::numeric_limits<float>::max()));
  }
  return collider.with_tie_bias(tie_bias);
}

std::string option_again(const ColliderChoice& choice) {
  if (!choice.is_given()) return "";
  if (choice.command.empty()) {
    const std::filesystem::path library(choice.name);
    std::string name =
        library.is_absolute() ? std::filesystem::proximate(library).string() : choice.name;
    if (is_library(choice.name) && !is_library(name)) name = "./" + name;
    return fmt::format("--{} {}", choice.role, quoted_for_shell(name));
  }
  return fmt::format("--{}-command {}{}", choice.role, quoted_for_shell(choice.command),
                     choice.keeps_points ? " --sequences" : "");
}

}  // namespace

double time_limit_of(const ExternalOptions& external) {
  const double seconds = external.time_limit.value_or(kTimeLimit);
  if (seconds > 0 && seconds <= kTimeLimitMax) return seconds;
  throw UserError(fmt::format("--time-limit: {} s is not a valid limit; use more than 0, up to {}",
                              seconds, kTimeLimitMax));
}

std::optional<ColliderChoice> named_choice(const ColliderChoice& by_name,
                                           const NamedSubjects& subjects) {
  const auto named = subjects.find(by_name.name);
  if (named == subjects.end()) return std::nullopt;
  const NamedSubject& subject = named->second;
  // Quiet or not: a file says what is started.
  write_error(fmt::format("{} is {}, as {} says\n", printable(by_name.name),
                          printable(subject.command + subject.library, 200),
                          printable(subject.file, 200)));
  return ColliderChoice{by_name.role, subject.library, subject.command, false};
}

Collider find_named(const ColliderChoice& choice, const std::string& name,
                    const ExternalOptions& external) {
  return find_by_its_name(name, [&] { return find_collider(choice, external); });
}

void expect_name(const Declaration& declaration, const std::string& name) {
  if (declaration.name == name) return;
  throw UserError(fmt::format("it is called '{}' there, but declares the name '{}'",
                              printable(name), printable(declaration.name)));
}

NamedColliders::Find find_installed_or_named(const NamedSubjects& subjects) {
  return [subjects](const std::string& name) -> std::optional<Collider> {
    const auto choice = named_choice({"subject", name, ""}, subjects);
    if (!choice) return find_installed(name);
    try {
      return find_named(*choice, name, {});
    } catch (const UserError& error) {
      write_complaint(error.what());
      return std::nullopt;
    }
  };
}

void add_collider(CLI::App& app, ColliderChoice& choice, const std::string& description) {
  CLI::Option* const name =
      add_text(app, "--" + choice.role, choice.name, "C|LIBRARY.so", description)
          ->capture_default_str()
          ->each([&choice](const std::string&) { choice.is_chosen = true; });
  add_text(app, "--" + choice.role + "-command", choice.command, "COMMAND",
           fmt::format("program to use as --{}: it reads cases and writes manifolds, a JSON line "
                       "each",
                       choice.role))
      ->excludes(name);
}

void add_subjects(CLI::App& app, std::string& file) {
  add_text(app, "--subjects", file, "FILE",
           "file that says how to start colliders that are not built in; default: subjects.json in "
           "the folder of known cases or beside it, if it belongs to you or to root");
}

void add_sequences(CLI::App& app, ColliderChoice& choice) {
  app.add_flag("--sequences", choice.keeps_points,
               "the program keeps points from frame to frame: send it sequences, one frame a line")
      ->needs("--" + choice.role + "-command");
}

void add_external_options(CLI::App& app, ExternalOptions& external) {
  app.add_flag("--in-process", external.in_process,
               "call a shared library from this process: faster, but a crash kills that worker");
  add_length(app, "--time-limit", external.time_limit,
             "seconds that a library or program may take for a case; default: 1, or as an engine's "
             "engine.json says");
}

void add_subject_and_oracle(CLI::App& app, SubjectAndOracle& colliders) {
  add_collider(app, colliders.subject, "collider under test");
  add_collider(app, colliders.oracle, "collider to compare the subject with");
  add_external_options(app, colliders.external);
}

namespace {

void tell_missing_ledger(const std::string& name) {
  if (!is_without_ledger(name)) return;
  write_remark(
      fmt::format("the ledger of {} is not in this build, so its known deviations count as new; "
                  "MANIFUZZ_ENGINES=all scripts/build builds it",
                  name));
}

}  // namespace

Collider find_collider(const ColliderChoice& choice, const ExternalOptions& external,
                       std::optional<double> tie_bias) {
  try {
    const Collider collider = find_any(choice, external);
    if (choice.command.empty()) tell_missing_ledger(choice.name);
    return tie_bias ? with_tie_bias(collider, *tie_bias) : collider;
  } catch (const UserError& error) {
    const std::string_view what = error.what();
    if (what.starts_with("--")) throw;
    const std::string_view suffix = choice.command.empty() ? "" : "-command";
    throw UserError(fmt::format("--{}{}: {}", choice.role, suffix, what));
  }
}

std::optional<Collider> given_collider(const ColliderChoice& choice,
                                       const ExternalOptions& external) {
  return choice.is_given() ? std::optional(find_collider(choice, external)) : std::nullopt;
}

std::string options_again(const SubjectAndOracle& colliders) {
  const std::string subject = option_again(colliders.subject);
  const std::string rest = options_again(colliders.oracle, colliders.external);
  return subject + (subject.empty() || rest.empty() ? "" : " ") + rest;
}

std::string options_to_show(const SubjectAndOracle& colliders) {
  const auto is_named = [](const ColliderChoice& choice) {
    return choice.command.empty() && choice.name.find('/') == std::string::npos;
  };
  if (is_named(colliders.subject) && is_named(colliders.oracle)) return "";
  return ' ' + options_again(colliders);
}

std::string options_again(const ColliderChoice& choice, const ExternalOptions& external) {
  std::string text = option_again(choice);
  if (external.in_process) text += " --in-process";
  if (external.time_limit) text += fmt::format(" --time-limit {}", *external.time_limit);
  return text;
}

}  // namespace manifuzz
