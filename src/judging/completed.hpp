#pragma once

#include "judging/admissible.hpp"

namespace manifuzz {

/// The manifold with what it leaves out set as the right manifold nearest to it has it, so that it
/// is judged by what it gave alone. Midpoints are moved to the incident edge.
Manifold<double> completed(const PartialManifold& given, const Admissible& right);

/// The same with a manifold of the case for a model, in place of the right ones.
Manifold<double> completed(const PartialManifold& given, const PairCase& pair,
                           const Manifold<double>& model);

/// The answer, a partial manifold completed; any other as it is.
Answer completed(Answer answer, const Admissible& right);

/// Whether two answers are equal, the reasons of a lost or declined one apart.
bool is_same(const Answer& one, const Answer& other);

/// A collider's answer, completed.
Answer whole(Answer answer, const PairCase& pair, const Declaration& declaration);

/// What the collider answers now, completed.
Answer ask(const Collider& collider, const PairCase& pair);

}  // namespace manifuzz
