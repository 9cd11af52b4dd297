#pragma once

#include <optional>
#include <string_view>

#include "geometry/collider.hpp"

namespace manifuzz {

/// Whether a collider that declares this has to be asked at all.
std::optional<Unsupported> beyond_limits(const Declaration& declaration, const PairCase& pair);

/// What must hold of any declaration from outside: a name that can name files, a finite bias.
/// Throws UserError that begins with `prefix` and the field.
void check_declaration(const Declaration& declaration, std::string_view prefix);

/// What answers many cases at once, as Collider::collide_many does.
using CollideMany = decltype(Collider::collide_many);

/// The collider of a process of its own: it is not asked what is beyond its limits.
Collider isolated(const Declaration& declaration, CollideMany collide_many);

}  // namespace manifuzz
