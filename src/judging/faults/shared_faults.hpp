#pragma once

#include <algorithm>
#include <cmath>

#include "judging/ledger.hpp"

namespace manifuzz {

// Faults that engines share which do not descend from each other.

/// No contact for overlapping polygons: of features that tie, one is kept whose slab misses.
bool no_contact_on_tied_features(const Deviation& deviation);
/// The normal is that of vertices that were rounded on the way: off by their roundoff over the
/// face's length.
bool normal_of_rounded_vertices(const Deviation& deviation);
/// A circle against a segment: the normal is the direction to the place on it that is nearest as
/// doubles have it, however short.
bool direction_to_place_on_segment(const Deviation& deviation);

namespace ledger_of {

// What faults of clips are recognised by.

/// Whether no contact was given of shapes that overlap.
inline bool misses_overlap(const Deviation& d) {
  return d.got.count == 0 && d.right.must_touch;
}

/// Whether a clip that would be right is such a one.
template <class Predicate>
bool any_candidate(const Deviation& d, const Predicate& predicate) {
  return std::ranges::any_of(d.right.candidates,
                             [&](const exact::Clip* clip) { return predicate(*clip); });
}

/// Whether a right clip of that side's face has no point where the incident edge misses its slab.
inline bool may_be_empty_from(const Deviation& d, Side side) {
  return any_candidate(d, [&](const exact::Clip& clip) {
    return clip.reference.side == side && may_be_empty(d.right, clip);
  });
}

/// The length of a face, a world length.
inline double length_of(const PairCase& pair, exact::FaceOf face) {
  return std::sqrt(exact::square<double>(pair, face));
}

}  // namespace ledger_of

}  // namespace manifuzz
