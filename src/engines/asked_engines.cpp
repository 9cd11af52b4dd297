#include "engines/asked_engines.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "engines/engine.hpp"
#include "engines/engine_texts.hpp"
#include "external/external_collider.hpp"
#include "external/timed_world.hpp"

namespace manifuzz {
namespace {

bool flag_of(const JsonView& object, std::string_view key) {
  const auto flag = object.find(key);
  return flag && flag->boolean();
}

EngineCollider collider_from(const JsonView& object) {
  object.expect_keys({"name", "description", "command", "library", "built", "linked",
                      "keeps_points", "seconds_max"});
  EngineCollider collider{.name = std::string(object.at("name").string()),
                          .description = std::string(object.at("description").string()),
                          .command = object.string_or("command", ""),
                          .library = object.string_or("library", ""),
                          .is_built = flag_of(object, "built"),
                          .is_linked = flag_of(object, "linked"),
                          .keeps_points = flag_of(object, "keeps_points")};
  if (const auto seconds = object.find("seconds_max")) collider.seconds_max = seconds->number();
  return collider;
}

EngineTimedWorld world_from(const JsonView& object) {
  object.expect_keys({"name", "library"});
  return {std::string(object.at("name").string()), std::string(object.at("library").string())};
}

AskedEngine engine_from(const EngineText& text) {
  const JsonTree tree = parse_json(text.json);
  const JsonView object(tree);
  object.expect_keys({"version", "cited_as", "descends_from", "needs", "tools", "package",
                      "colliders", "timed_worlds"});
  AskedEngine engine{.name = std::string(text.name),
                     .version = std::string(object.at("version").string()),
                     .cited_as = object.string_or("cited_as", fmt::format("{} {{}}", text.name)),
                     .needs = object.string_or("needs", ""),
                     .tools = object.string_or("tools", ""),
                     .package = object.string_or("package", ""),
                     .colliders = {},
                     .timed_worlds = {}};
  for (const JsonView& one : object.at("colliders").elements()) {
    engine.colliders.push_back(collider_from(one));
  }
  if (const auto worlds = object.find("timed_worlds")) {
    for (const JsonView& one : worlds->elements()) engine.timed_worlds.push_back(world_from(one));
  }
  return engine;
}

std::string folder_of(const AskedEngine& engine) {
  return fmt::format("{}/{}", kEnginesFolder, engine.name);
}

/// With the engine's folder in the place of each @.
std::string in_folder(std::string_view text, const std::string& folder) {
  std::string result(text);
  for (std::size_t at = 0; (at = result.find("@/", at)) != std::string::npos;) {
    result.replace(at, 1, folder);
    at += folder.size();
  }
  return result;
}

/// Throws UserError where what is asked is not there.
void expect_installed(const AskedEngine& engine, const EngineCollider& asked) {
  const std::string& needed = engine.needs.empty() ? asked.library : engine.needs;
  if (std::filesystem::exists(in_folder(needed, folder_of(engine)))) return;
  throw UserError(
      fmt::format("{} is not installed; scripts/setup --engines installs it, which needs {}",
                  asked.name, engine.tools));
}

}  // namespace

std::span<const AskedEngine> asked_engines() {
  static const std::vector<AskedEngine> all = [] {
    std::vector<AskedEngine> engines;
    for (const EngineText& text : engine_texts()) engines.push_back(engine_from(text));
    return engines;
  }();
  return all;
}

std::optional<FoundCollider> find_asked(std::string_view collider) {
  for (const AskedEngine& engine : asked_engines()) {
    const EngineCollider* const asked = find_by_name(engine.colliders, collider);
    if (asked != nullptr) return FoundCollider{&engine, asked};
  }
  return std::nullopt;
}

std::string left_out(std::string_view name, const AskedEngine& engine) {
  return fmt::format(
      "{} is not in this build; scripts/setup --engines installs {}, then MANIFUZZ_ENGINES=all "
      "scripts/build builds it",
      name, engine.package);
}

std::string library_of(const AskedEngine& engine, const EngineCollider& asked) {
  if (asked.is_built) {
    const std::string library = fmt::format("{}/{}.so", kBuiltLibraries, asked.name);
    if (!std::filesystem::exists(library)) throw UserError(left_out(asked.name, engine));
    return library;
  }
  expect_installed(engine, asked);
  if (!asked.library.empty()) return in_folder(asked.library, folder_of(engine));
  throw UserError(
      fmt::format("{} is a program, whose time is mostly that of passing cases; only libraries are "
                  "timed",
                  asked.name));
}

std::optional<std::string> library_of_installed(std::string_view collider) {
  const auto found = find_asked(collider);
  if (!found || found->asked->is_built || found->asked->is_linked) return std::nullopt;
  return library_of(*found->engine, *found->asked);
}

std::vector<EngineTimedWorld> installed_timed_worlds() {
  std::vector<EngineTimedWorld> installed;
  for (const AskedEngine& engine : asked_engines()) {
    for (const EngineTimedWorld& world : engine.timed_worlds) {
      const std::string library = in_folder(world.library, folder_of(engine));
      if (has_timed_worlds(library)) installed.push_back({world.name, library});
    }
  }
  return installed;
}

Collider collider_of(const AskedEngine& engine, const EngineCollider& asked) {
  const bool is_library = asked.is_built || !asked.library.empty();
  if (!is_library) expect_installed(engine, asked);
  Collider collider =
      is_library
          ? collider_in_own_process(library_of(engine, asked), asked.seconds_max)
          : collider_of_command(in_folder(asked.command, quoted_for_shell(folder_of(engine))),
                                asked.seconds_max);
  collider.declaration.description = asked.description;
  return collider;
}

bool is_without_ledger(std::string_view collider) {
  const auto found = find_asked(collider);
  return found && find_by_name(built_engines(), found->engine->name) == nullptr;
}

}  // namespace manifuzz
