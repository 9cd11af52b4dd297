#include "cli/colliders.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/engines.hpp"
#include "cli/sequence_colliders.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {

std::string left_out(std::string_view name, std::string_view package) {
  return fmt::format(
      "{} is not in this build; scripts/setup --engines installs {}, then scripts/build builds it",
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
