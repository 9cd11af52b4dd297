#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "geometry/collider.hpp"

namespace manifuzz {

/// Whether a collider that declares this has to be asked at all.
std::optional<Unsupported> beyond_limits(const Declaration& declaration, const PairCase& pair);

/// What must hold of any declaration from outside: a name that can name files, a finite bias.
/// Throws UserError that begins with `prefix` and the field.
void check_declaration(const Declaration& declaration, std::string_view prefix);

/// A collider that does nothing but die or hang is not worth all the cases.
inline constexpr int kLossesInARowMax = 20;

/// Whether the last kLossesInARowMax of the first `done` answers were all lost.
bool is_hopeless(std::span<const Answer> answers, std::size_t done);

/// What answers many cases at once, as Collider::collide_many does.
using CollideMany = decltype(Collider::collide_many);

/// The collider of a process of its own, which takes up to so long over a case: it is not asked
/// what is beyond its limits.
Collider isolated(const Declaration& declaration, double seconds_max, CollideMany collide_many);

}  // namespace manifuzz
