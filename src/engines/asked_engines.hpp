#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "engines/engine.hpp"

namespace manifuzz {

/// A collider as its engine's engine.json says how it is asked. In texts @ is the engine's folder.
struct EngineCollider {
  std::string name;         ///< as it declares itself
  std::string description;  ///< one line for `list colliders`
  std::string command;      ///< of a program, or empty
  std::string library;      ///< a shared library, or empty
  bool is_built = false;    ///< the build makes its shared library
  bool is_linked = false;   ///< it is in this program, where its engine is
  bool keeps_points = false;
  double seconds_max = 1;  ///< over a case
};

/// A world that an engine's shared library has, after manifuzz_timed_world.h.
struct EngineTimedWorld {
  std::string name;     ///< as the library knows it
  std::string library;  ///< its path
};

/// An engine's engine.json.
struct AskedEngine {
  std::string name;      ///< its folder's
  std::string version;   ///< that its ledger is of
  std::string cited_as;  ///< how its ledger's sources begin, {} in the place of the version
  std::string needs;     ///< a file without which it cannot be asked; empty: its library
  std::string tools;     ///< with what scripts/setup --engines can get that
  std::string package;   ///< Debian's, that it is built with
  std::vector<EngineCollider> colliders;
  std::vector<EngineTimedWorld> timed_worlds;  ///< for scenes to be held against
};

/// Every engine in oracle/, whether built or not, in the order of oracle/engines.txt.
std::span<const AskedEngine> asked_engines();

/// An engine, and the collider of that name that it has.
struct FoundCollider {
  const AskedEngine* engine;
  const EngineCollider* asked;
};
std::optional<FoundCollider> find_asked(std::string_view collider);

/// Throws UserError that says what would make it so, where it cannot be asked here.
Collider collider_of(const AskedEngine& engine, const EngineCollider& asked);

/// The collider's shared library. Throws UserError where it is not there, and where it is asked as
/// a program.
std::string library_of(const AskedEngine& engine, const EngineCollider& asked);

/// The shared library of an engine's collider of that name that no build makes; nothing where there
/// is none such. Throws UserError where it is not there, and where it is asked as a program.
std::optional<std::string> library_of_installed(std::string_view collider);

/// The engines' worlds whose libraries are there, each with its library's path.
std::vector<EngineTimedWorld> installed_timed_worlds();

/// Why the build left it out: one line for people.
std::string left_out(std::string_view name, const AskedEngine& engine);

/// What an engine that is built has of that name among some of its parts, such as its colliders.
/// Throws UserError where the build left it out.
template <class Entry>
auto make_linked(std::vector<Entry> Engine::*entries, const AskedEngine& engine,
                 const EngineCollider& asked) {
  for (const Engine& built : built_engines()) {
    const Entry* const entry = find_by_name(built.*entries, asked.name);
    if (entry != nullptr) return entry->make();
  }
  throw UserError(left_out(asked.name, engine));
}

/// Whether an engine has that collider of which this program knows no ledger: what it is known for
/// looks new.
bool is_without_ledger(std::string_view collider);

}  // namespace manifuzz
