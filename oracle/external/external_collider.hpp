#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "collider/collider.hpp"

namespace manifuzz {

/// Whether a collider that declares this has to be asked at all.
std::optional<Unsupported> beyond_limits(const Declaration& declaration, const PairCase& pair);

/// Whether it can name a collider, and thus files: 1 to 40 letters, digits, - _ or dots.
bool is_collider_name(std::string_view name);

/// What must hold of the declaration of any program or library: a name that can name files, a
/// finite bias, a snippet whose blanks can be filled in. Throws UserError that begins with `prefix`
/// and the field.
void check_declaration(const Declaration& declaration, std::string_view prefix);

/// So many cases are asked at once: enough to hide the round trip's cost, few enough for the cache.
inline constexpr std::size_t kBatch = 256;

/// A collider that does nothing but die or hang is not worth all the cases.
inline constexpr int kLossesInARowMax = 20;

/// Whether the last kLossesInARowMax of the first `done` answers were all lost.
bool is_unresponsive(std::span<const Answer> answers, std::size_t done);

/// What answers up to kBatch cases, as Collider::collide_many does: one at least, unless told to
/// stop.
using AnswerBatch = decltype(Collider::collide_many);

/// The collider of a process of its own, which takes up to so long over a case: it is not asked
/// what is beyond its limits.
Collider isolated(const Declaration& declaration, double seconds_max, AnswerBatch answer_batch);

}  // namespace manifuzz
