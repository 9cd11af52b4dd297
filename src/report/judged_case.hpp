#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include "corpus/corpus.hpp"
#include "judging/judge.hpp"

namespace manifuzz {

/// A collider that was asked, and what it said, completed.
struct DeclaredAnswer {
  Declaration declaration;
  Answer answer;

  /// Its manifold, or nullptr where it gave none. It may be malformed.
  const Manifold<double>* manifold() const { return std::get_if<Manifold<double>>(&answer); }
  /// The number of its points, 0 to 2 whatever a malformed manifold says.
  int count() const { return manifold() ? std::clamp(manifold()->count, 0, 2) : 0; }
};

/// A case and what it comes to between two colliders: what `show` shows.
struct JudgedCase {
  CorpusCase given;
  DeclaredAnswer subject;
  DeclaredAnswer oracle;
  Judgement judgement;
};

/// The candidate that a picture shows: the subject's own choice where that is right, else the first
/// whose incident edge meets the slab, else the first; nullptr where the polygons are apart.
const exact::Clip* candidate_to_show(const Admissible& right, const DeclaredAnswer& subject);

}  // namespace manifuzz
