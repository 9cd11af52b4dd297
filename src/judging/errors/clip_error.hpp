#pragma once

#include "judging/admissible.hpp"
#include "judging/errors/answer_error.hpp"

namespace manifuzz {

/// How wrong a manifold is that is none of the right ones: its error against the clip that it is
/// nearest to. That is any of the right ones, or the clip of any other face, which has the excess
/// of that face besides; its points are matched in the way that leaves the least error. A wrong
/// reference side or feature has no length: where nothing else is wrong, no component is.
AnswerError clip_error(const Manifold<double>& manifold, const Admissible& right);

/// The kind of a wrong clip: that of its greatest error.
Kind kind_of_clip(const AnswerError& error, const Manifold<double>& manifold,
                  const Admissible& right);

/// The component that a kind stands for where it is judged by that alone.
Component component_of(Kind kind);

}  // namespace manifuzz
