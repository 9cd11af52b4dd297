#include "engines/colliders.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "base/text.hpp"
#include "engines/asked_engines.hpp"
#include "engines/sequence_colliders.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// In the order in which they are listed.
std::vector<ColliderEntry> own_entries() {
  return {
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
  };
}

ColliderEntry entry_of(const AskedEngine& engine, const EngineCollider& asked) {
  if (asked.is_linked) {
    return {asked.name, [&] { return make_linked(&Engine::colliders, engine, asked); }};
  }
  return {asked.name, [&] { return collider_of(engine, asked); }};
}

/// This repository's own, then the engines' of which `is_wanted` tells.
template <class IsWanted>
std::vector<ColliderEntry> own_and(const IsWanted& is_wanted) {
  std::vector<ColliderEntry> all = own_entries();
  for (const AskedEngine& engine : asked_engines()) {
    for (const EngineCollider& asked : engine.colliders) {
      if (!asked.keeps_points && is_wanted(asked)) all.push_back(entry_of(engine, asked));
    }
  }
  return all;
}

}  // namespace

const std::vector<ColliderEntry>& linked_colliders() {
  static const std::vector<ColliderEntry> all =
      own_and([](const EngineCollider& asked) { return asked.is_built || asked.is_linked; });
  return all;
}

const std::vector<ColliderEntry>& colliders() {
  static const std::vector<ColliderEntry> all = own_and([](const EngineCollider&) { return true; });
  return all;
}

std::string_view usual_oracle_name() {
  return asked_engines().front().colliders.front().name;
}

Collider usual_oracle() {
  return find_collider(usual_oracle_name());
}

const ColliderEntry* find_entry(std::string_view name) {
  return find_by_name(colliders(), name);
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
    throw UserError(fmt::format(
        "{}: {} does not give one point a pair; one that does, such as gjk, is expected", name,
        over));
  }
  if (collider.declaration.alters_shapes) {
    throw UserError(
        fmt::format("{}: {} alters shapes; a collider that leaves them as they are is "
                    "expected",
                    name, over));
  }
  return collider;
}

Collider find_collider(std::string_view name) {
  if (const ColliderEntry* const entry = find_entry(name)) return entry->make();
  if (const auto base = find_made_over("perturbed+", name)) return make_perturbed_over(*base);
  if (find_sequence_entry(name) != nullptr) {
    throw UserError(
        fmt::format("{} keeps points from frame to frame: it takes sequences, and these are "
                    "pair cases",
                    name));
  }
  std::vector<std::string_view> names = names_of(colliders());
  std::ranges::copy(names_of(sequence_colliders()), std::back_inserter(names));
  names.emplace_back("perturbed+NAME");
  names.emplace_back("./LIBRARY.so");
  throw UserError(no_such("collider", name, names));
}

}  // namespace manifuzz
