#pragma once

#include <string_view>
#include <vector>

#include "engines/engine.hpp"

namespace manifuzz {

/// Every collider that keeps points over frames, in the order of `list colliders`.
const std::vector<SequenceColliderEntry>& sequence_colliders();

/// The entry of that name, or nullptr.
const SequenceColliderEntry* find_sequence_entry(std::string_view name);

/// The collider of that name, or, for cached+NAME and cached-bullet+NAME, the points of the
/// collider NAME of `list colliders`, which gives one, kept in either way. Throws UserError that
/// lists the names, or says why NAME will not do.
SequenceCollider find_sequence_collider(std::string_view name);

}  // namespace manifuzz
