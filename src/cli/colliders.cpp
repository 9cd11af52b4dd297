#include "cli/colliders.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/engines.hpp"
#include "cli/options.hpp"
#include "cli/sequence_colliders.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"
#include "report/outputs.hpp"

namespace manifuzz {

std::string left_out(std::string_view name, std::string_view package) {
  return fmt::format(
      "the build left out {}; scripts/setup --engines installs {}, and scripts/build builds it",
      name, package);
}

namespace {

/// Over a case.
constexpr double kSecondsMax = 1;

Collider described(Collider collider, std::string description) {
  collider.declaration.description = std::move(description);
  return collider;
}

Collider make_chipmunk() {
  return described(collider_in_own_process(MANIFUZZ_CHIPMUNK, kSecondsMax),
                   "Chipmunk's cpShapesCollide (GJK and EPA), in a process of its own");
}

/// An engine that is asked where the build found it, as a library that the build made.
Collider of_engine(std::string_view name, std::string_view package, std::string description) {
  const std::filesystem::path library =
      std::filesystem::path(MANIFUZZ_ENGINES) / fmt::format("{}.so", name);
  if (!std::filesystem::exists(library)) {
    throw UserError(left_out(name, package));
  }
  return described(collider_in_own_process(library.string(), kSecondsMax), std::move(description));
}

Collider of_bullet(std::string_view name, std::string_view how) {
  return of_engine(name, "libbullet-dev", fmt::format("Bullet's {}", how));
}

Collider of_libccd(std::string_view name, std::string_view how) {
  return of_engine(name, "libccd-dev", fmt::format("libccd's {}, of prisms", how));
}

}  // namespace

const std::vector<ColliderEntry>& linked_colliders() {
  static const std::vector<ColliderEntry> all = {
      {"clip", [] { return make_clip(); }, true},
      {"clip64", [] { return make_clip64(); }, true},
      {"pair", [] { return manifuzz::make_pair(); }, true},
      {"batch", [] { return make_batch(); }, true},
      {"batch64", [] { return make_batch64(); }, true},
      {"gjk", make_gjk},
      {"gjk64", make_gjk64},
      {"gjk-shrunk", make_gjk_shrunk},
      {"gjk-clip", make_gjk_clip},
      {"perturbed", make_perturbed},
      {"perturbed64", make_perturbed64},
      {"box2d", [] { return make_box2d(); }},
      {"chipmunk", make_chipmunk},
      {"bullet-epa",
       [] { return of_bullet("bullet-epa", "btGjkPairDetector with its EPA, of prisms"); }},
      {"bullet-minkowski",
       [] {
         return of_bullet("bullet-minkowski",
                          "btGjkPairDetector with its 42 directions, of prisms");
       }},
      {"bullet-convex2d",
       [] {
         return of_bullet("bullet-convex2d",
                          "btConvex2dConvex2dAlgorithm with its 42 directions, of flat hulls");
       }},
      {"bullet-perturbed",
       [] {
         return of_bullet("bullet-perturbed",
                          "btConvexConvexAlgorithm, perturbed three times, of prisms");
       }},
      {"libccd-gjk", [] { return of_libccd("libccd-gjk", "ccdGJKPenetration"); }},
      {"libccd-mpr", [] { return of_libccd("libccd-mpr", "ccdMPRPenetration"); }},
  };
  return all;
}

const std::vector<ColliderEntry>& colliders() {
  static const std::vector<ColliderEntry> all = [] {
    std::vector<ColliderEntry> entries = linked_colliders();
    for (const Engine& engine : engines()) {
      entries.push_back({engine.name, [&engine] { return collider_of(engine); }});
    }
    return entries;
  }();
  return all;
}

const ColliderEntry* find_entry(std::string_view name) {
  const auto entry = std::ranges::find(colliders(), name, &ColliderEntry::name);
  return entry == colliders().end() ? nullptr : &*entry;
}

std::optional<Collider> find_installed(const std::string& name) {
  try {
    return find_collider(name);
  } catch (const UserError&) {
    return std::nullopt;
  }
}

std::optional<Collider> find_made_over(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  const std::string_view over = name.substr(prefix.size());
  const Collider collider = find_collider(over);
  if (collider.declaration.claims != Claims::point) {
    throw UserError(fmt::format("{}: {} does not claim one point a pair, as gjk does", name, over));
  }
  if (collider.declaration.alters_shapes) {
    throw UserError(
        fmt::format("{}: {} alters shapes; it is made over those that take them as "
                    "they are",
                    name, over));
  }
  return collider;
}

Collider find_collider(std::string_view name) {
  if (const ColliderEntry* const entry = find_entry(name)) return entry->make();
  if (const auto base = find_made_over("perturbed+", name)) return make_perturbed_over(*base);
  if (find_sequence_entry(name) != nullptr) {
    throw UserError(
        fmt::format("{} keeps points over frames: it takes sequences, and these are "
                    "pair cases",
                    name));
  }
  std::vector<std::string_view> names = names_of(colliders());
  std::ranges::copy(names_of(sequence_colliders()), std::back_inserter(names));
  names.emplace_back("perturbed+NAME");
  names.emplace_back("./LIBRARY.so");
  throw UserError(no_such("collider", name, names));
}

namespace {

constexpr double kTimeLimit = 1;
constexpr double kTimeLimitMax = 3600;

bool is_library(const std::string& name) {
  return name.find('/') != std::string::npos || name.ends_with(".so");
}

Collider find_any(const ColliderChoice& choice, const ExternalOptions& external) {
  const double seconds = time_limit_of(external);
  if (external.in_process && external.time_limit) {
    throw UserError(
        "--time-limit: holds for colliders in processes of their own; leave out --in-process");
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
  if (!is_library(choice.name)) return find_collider(choice.name);
  return external.in_process ? collider_in_process(choice.name)
                             : collider_in_own_process(choice.name, seconds);
}

Collider with_tie_bias(const Collider& collider, double tie_bias) {
  if (!collider.with_tie_bias) {
    throw UserError(fmt::format("--tie-bias: that of {} is fixed at {}", collider.declaration.name,
                                in_words(collider.declaration.tie_bias)));
  }
  if (tie_bias > static_cast<double>(std::numeric_limits<float>::max())) {
    throw UserError(fmt::format("--tie-bias: {:g} is beyond float; take 0 to {:g}", tie_bias,
                                std::numeric_limits<float>::max()));
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
  throw UserError(fmt::format("--time-limit: {} s is no limit; more than 0, up to {} is expected",
                              seconds, kTimeLimitMax));
}

std::optional<ColliderChoice> named_choice(const ColliderChoice& by_name,
                                           const NamedSubjects& subjects) {
  const auto named = subjects.find(by_name.name);
  if (named == subjects.end()) return std::nullopt;
  return ColliderChoice{by_name.role, named->second.library, named->second.command, false};
}

Collider find_named(const ColliderChoice& choice, const std::string& name,
                    const ExternalOptions& external) {
  try {
    Collider found = find_collider(choice, external);
    if (found.declaration.name == name) return found;
    throw UserError(fmt::format("is called '{}' there, and declares the name '{}'", printable(name),
                                printable(found.declaration.name)));
  } catch (const UserError& error) {
    throw UserError(fmt::format("subjects.json: {}: {}", printable(name), error.what()));
  }
}

NamedColliders::Find find_installed_or_named(std::vector<std::filesystem::path> corpora) {
  return [subjects = read_subjects(corpora)](const std::string& name) -> std::optional<Collider> {
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
          ->capture_default_str();
  add_text(app, "--" + choice.role + "-command", choice.command, "COMMAND",
           "the same as a program: case lines in, manifold lines out")
      ->excludes(name);
}

void add_sequences(CLI::App& app, ColliderChoice& choice) {
  app.add_flag("--sequences", choice.keeps_points,
               "the program keeps points: it gets sequences, a frame a line")
      ->needs("--" + choice.role + "-command");
}

void add_external_options(CLI::App& app, ExternalOptions& external) {
  app.add_flag("--in-process", external.in_process,
               "call a shared library from this process: faster, but where it dies, so does a job");
  add_length(app, "--time-limit", external.time_limit,
             "seconds that a library or a program may take over a case; 1 if not given");
}

void add_subject_and_oracle(CLI::App& app, SubjectAndOracle& colliders) {
  add_collider(app, colliders.subject, "the collider under test");
  add_collider(app, colliders.oracle, "the collider it is held against");
  add_external_options(app, colliders.external);
}

Collider find_collider(const ColliderChoice& choice, const ExternalOptions& external,
                       std::optional<double> tie_bias) {
  try {
    const Collider collider = find_any(choice, external);
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

std::string options_again(const ColliderChoice& choice, const ExternalOptions& external) {
  std::string text = option_again(choice);
  if (external.in_process) text += " --in-process";
  if (external.time_limit) text += fmt::format(" --time-limit {}", *external.time_limit);
  return text;
}

}  // namespace manifuzz
