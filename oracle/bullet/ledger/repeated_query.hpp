#pragma once

#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/bullet/ledger/epa.hpp"

namespace manifuzz::ledger_of {

/// What an engine answers, repeated.
struct RepeatedQuery {
  BulletAsked asked = BulletAsked::epa;
  BulletAnswer answer;
  MinkowskiTrace directions;
  EpaTrace epa;

  /// The loop whose closest points the answer is made of: the first one, or the displaced one.
  const QueryLoop& deciding() const {
    return answer.normal_of == NormalOf::solver ? directions.beside.loop : answer.loop;
  }
};

RepeatedQuery repeat_query(const PairCase& pair, BulletAsked asked);

/// Whether it is what was answered, a point across a gap too: but for the adapter's and the
/// manifold's own roundings, which are the bound's.
bool is_answered(const Deviation& deviation, const RepeatedQuery& query);

/// Whether it ended at the corner that roundings of products made the nearest of a hull's along the
/// axis: another is nearer, by no more than REL_ERROR2 of the squared distance, which would have
/// ended it as well.
bool is_nearest_corner_rounded(const PairCase& pair, BulletAsked asked, const QueryLoop& loop);

}  // namespace manifuzz::ledger_of
