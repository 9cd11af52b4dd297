#pragma once

#include <algorithm>

#include "corpus/corpus.hpp"
#include "judging/judge.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// A collider's answer, completed, with its declaration.
struct DeclaredAnswer {
  Declaration declaration;
  Answer answer;

  /// Its manifold, or nullptr where it gave none. It may be malformed.
  const Manifold<double>* manifold() const { return std::get_if<Manifold<double>>(&answer); }
  /// The number of its points, 0 to 2 whatever a malformed manifold says.
  int count() const { return manifold() ? std::clamp(manifold()->count, 0, 2) : 0; }
};

/// A case, what two colliders answer, and the verdict: what `show` shows.
struct JudgedCase {
  CorpusCase given;
  DeclaredAnswer subject;
  DeclaredAnswer oracle;
  Judgement judgement;
};

/// The collider is asked in a child process, where it could take this one along. Throws
/// Interrupted.
DeclaredAnswer declared_answer(const Collider& collider, const PairCase& pair,
                               Interruption& interruption);

/// Both are asked so. Throws Interrupted.
JudgedCase judged_case(const CorpusCase& given, const Collider& subject, const Collider& oracle,
                       Interruption& interruption);

}  // namespace manifuzz
