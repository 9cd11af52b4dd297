#include "cli/colliders.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>

#include "base/names.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "oracle/box2d/box2d.hpp"
#include "oracle/external/command.hpp"
#include "oracle/external/hosted_library.hpp"
#include "own_colliders/clip.hpp"
#include "own_colliders/kernel.hpp"

namespace manifuzz {

namespace {

/// Over a case.
constexpr double kSecondsMax = 1;

Collider described(Collider collider, std::string description) {
  collider.declaration.description = std::move(description);
  return collider;
}

Collider make_chipmunk() {
  return described(collider_in_own_process(MANIFUZZ_CHIPMUNK, kSecondsMax),
                   "Chipmunk's cpShapesCollide, in a process of its own");
}

/// An engine of npm's, asked through its adapter.
Collider of_node(std::string_view name) {
  const std::filesystem::path folder(MANIFUZZ_NODE_COLLIDERS);
  if (!std::filesystem::exists(folder / "node_modules" / name)) {
    throw UserError(
        fmt::format("{} is not installed; scripts/setup installs it where node and npm are", name));
  }
  const auto adapter = folder / fmt::format("{}.mjs", name);
  return described(collider_of_command("node " + quoted_for_shell(adapter.string()), kSecondsMax),
                   fmt::format("{} of npm, under node", name));
}

Collider make_planck() {
  return of_node("planck");
}

Collider make_phaser_box2d() {
  return of_node("phaser-box2d");
}

}  // namespace

const std::vector<ColliderEntry>& colliders() {
  static const std::vector<ColliderEntry> all = {
      {"clip", [] { return make_clip(); }, true},
      {"clip64", [] { return make_clip64(); }, true},
      {"pair", [] { return manifuzz::make_pair(); }, true},
      {"batch", [] { return make_batch(); }, true},
      {"batch64", [] { return make_batch64(); }, true},
      {"box2d", [] { return make_box2d(); }},
      {"chipmunk", make_chipmunk},
      {"planck", make_planck},
      {"phaser-box2d", make_phaser_box2d},
  };
  return all;
}

const ColliderEntry* find_entry(std::string_view name) {
  const auto entry = std::ranges::find(colliders(), name, &ColliderEntry::name);
  return entry == colliders().end() ? nullptr : &*entry;
}

std::optional<Collider> find_installed(const std::string& name) {
  try {
    const ColliderEntry* const entry = find_entry(name);
    return entry == nullptr ? std::nullopt : std::optional(entry->make());
  } catch (const UserError&) {
    return std::nullopt;
  }
}

Collider find_collider(std::string_view name) {
  if (const ColliderEntry* const entry = find_entry(name)) return entry->make();
  std::vector<std::string_view> names = names_of(colliders());
  names.emplace_back("./LIBRARY.so");
  throw UserError(no_such("collider", name, names));
}

}  // namespace manifuzz
