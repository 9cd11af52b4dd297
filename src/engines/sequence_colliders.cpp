#include "engines/sequence_colliders.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.hpp"
#include "engines/asked_engines.hpp"
#include "engines/colliders.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// A way to keep the points of another collider, by what stands before that one's name.
struct Way {
  std::string_view prefix;
  SequenceCollider (*over)(const Collider& one_point);
};

constexpr Way kWays[] = {{"cached+", cached_over}, {"cached-bullet+", cached_bullet_over}};

}  // namespace

const std::vector<SequenceColliderEntry>& sequence_colliders() {
  static const std::vector<SequenceColliderEntry> all = [] {
    std::vector<SequenceColliderEntry> entries = {
        {"cached", make_cached, true},
        {"cached64", make_cached64, true},
        {"cached-bullet", make_cached_bullet, true},
    };
    for (const AskedEngine& engine : asked_engines()) {
      for (const EngineCollider& asked : engine.colliders) {
        if (!asked.keeps_points) continue;
        entries.push_back(
            {asked.name, [&] { return make_linked(&Engine::keepers, engine, asked); }});
      }
    }
    return entries;
  }();
  return all;
}

const SequenceColliderEntry* find_sequence_entry(std::string_view name) {
  return find_by_name(sequence_colliders(), name);
}

SequenceCollider find_sequence_collider(std::string_view name) {
  if (const SequenceColliderEntry* const entry = find_sequence_entry(name)) return entry->make();
  for (const Way& way : kWays) {
    if (const auto one_point = find_made_over(way.prefix, name)) return way.over(*one_point);
  }
  std::vector<std::string_view> names = names_of(sequence_colliders());
  names.emplace_back("cached+NAME");
  names.emplace_back("cached-bullet+NAME");
  throw UserError(no_such("collider that keeps points", name, names));
}

}  // namespace manifuzz
