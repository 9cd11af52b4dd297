#include <algorithm>
#include <array>

#include "oracle/bullet/ledger/manifold.hpp"
#include "oracle/bullet/ledger/repeated_query.hpp"
#include "oracle/bullet/ledger/rows.hpp"

// What btConvex2dConvex2dAlgorithm's flat hulls alone come to, repeated in its own floats.

namespace manifuzz {
namespace {

/// The answer where the detector takes cores for intersecting, or does not, of which it had a
/// corner that is none of theirs: -1 indexes their corners.
bool corner_before_first(const Deviation& d) {
  const ledger_of::BulletPair hulls = ledger_of::flat_hulls_of(d.right.pair());
  if (!ledger_of::is_intersection_of_memory(hulls)) return false;
  return std::ranges::any_of(std::array{true, false}, [&](bool do_intersect) {
    ledger_of::RepeatedQuery query;
    query.answer =
        ledger_of::ask_detector_told(do_intersect, hulls, ledger_of::solve_by_directions,
                                     &query.directions, ledger_of::farthest_square_of(hulls));
    return ledger_of::is_answered(d, query);
  });
}

/// No contact, though the query's point touches: taken to both shapes' frames and back, its places
/// are beside each other or apart, and refreshContactPoints leaves it out.
bool point_left_out_by_refresh(const Deviation& d) {
  if (d.got.count > 0) return false;
  const ledger_of::BulletPair hulls = ledger_of::flat_hulls_of(d.right.pair());
  const ledger_of::BulletAnswer answer =
      ledger_of::repeat_query(d.right.pair(), ledger_of::BulletAsked::flat).answer;
  if (answer.normal_of == ledger_of::NormalOf::nobody) return false;
  ledger_of::BulletManifold manifold(hulls, ledger_of::breaking_threshold(hulls));
  manifold.add(answer.normal, answer.on_b, answer.distance, 0);
  if (ledger_of::deepest_of(manifold.points) == nullptr) return false;
  manifold.refresh();
  return ledger_of::deepest_of(manifold.points) == nullptr;
}

constexpr LedgerRow kRowsOfFlat[] = {{"corner-before-first", corner_before_first},
                                     {"refreshed", point_left_out_by_refresh}};

}  // namespace

LedgerRows bullet_flat_ledger() {
  return {"bullet-convex2d", kRowsOfFlat};
}

}  // namespace manifuzz
