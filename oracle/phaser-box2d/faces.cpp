#include <algorithm>

#include "judging/faults/shared_faults.hpp"
#include "judging/manifold_error.hpp"
#include "oracle/phaser-box2d/deviations.hpp"

// phaser-box2d on polygons.

namespace manifuzz {

using namespace ledger_of;

bool edge_extended_to_slab(const Deviation& d) {
  const bool fits = d.kind == Kind::position || d.kind == Kind::depth || d.kind == Kind::count ||
                    d.kind == Kind::phantom_contact;
  const Bounds& bounds = d.right.bounds;
  const auto misses = [&](const exact::Clip* clip) {
    return compare_gap(*clip, -bounds.separation) > 0;
  };
  return fits && (std::ranges::any_of(clips_within(*d.right.truth, Side::a, bounds), misses) ||
                  std::ranges::any_of(clips_within(*d.right.truth, Side::b, bounds), misses));
}

bool incident_edge_unclipped(const Deviation& d) {
  constexpr double too_short = 1e-10;  // manifold_c.js: eps
  const bool fits = d.kind == Kind::position || d.kind == Kind::depth || d.kind == Kind::count;
  return fits && any_candidate(d, [](const exact::Clip& clip) {
           return clip.edge_length * clip.cosine <= too_short;
         });
}

}  // namespace manifuzz
