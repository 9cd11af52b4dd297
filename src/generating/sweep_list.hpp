#pragma once

#include "generating/sweep.hpp"

/// The one list of sweeps: a name, what its knob is and its unit, the knob's values, and a line for
/// `list sweeps`. Each is a function of that name below, defined in a file of its theme
/// (sweeps_*.cpp). A case depends on the name, not on the place.
#define MANIFUZZ_SWEEPS(SWEEP)                                                                    \
  SWEEP(distance, "distance from the origin", "world lengths, of polygons 0.5 to 3 across",       \
        rising({1, 2, 5}, 0, 8), "both bodies far from the world's origin")                       \
  SWEEP(angle, "angle between facing faces", "its tangent", falling({10, 5, 2}, 0, -9),           \
        "two facing faces, ever nearer to parallel")                                              \
  SWEEP(aspect, "aspect ratio", "length over thickness", rising({1, 2, 5}, 0, 8),                 \
        "one polygon or both ever thinner")                                                       \
  SWEEP(small, "size, downwards", "world lengths", falling({10, 3}, 0, -18),                      \
        "everything ever smaller")                                                                \
  SWEEP(large, "size, upwards", "world lengths", rising({1, 3}, 0, 18), "everything ever larger") \
  SWEEP(ratio, "size ratio", "larger over smaller", rising({1, 2, 3, 5}, 0, 6),                   \
        "one polygon ever smaller than the other")                                                \
  SWEEP(depth, "depth", "share of the size", falling({10, 5, 2}, 0, -9),                          \
        "an overlap from the whole size to almost none")                                          \
  SWEEP(collinear, "turn at a vertex", "its tangent", falling({10, 5, 2}, -1, -9),                \
        "a vertex on a face at the contact, ever less out of line")                               \
  SWEEP(chamfer, "chamfer", "share of its polygon's size", falling({10, 5, 3, 2}, -1, -7),        \
        "a corner at the contact cut ever smaller")                                               \
  SWEEP(off_unit, "rotation off unit", "|cos^2 + sin^2 - 1|", kOffUnitValues,                     \
        "rotations that are ever less unit")                                                      \
  SWEEP(tie, "lead of a face", "ulps from a tie", powers_of_two_to_zero(20),                      \
        "two faces, or two incident edges, ever nearer to a tie")                                 \
  SWEEP(touch, "gap", "ulps from touching", powers_of_two_to_zero(20),                            \
        "a gap, or an overlap, ever nearer to none")                                              \
  SWEEP(corner, "end of an edge", "ulps from the side plane", powers_of_two_to_zero(20),          \
        "an end of the incident edge ever nearer to where it is clipped")

namespace manifuzz::turn {

#define MANIFUZZ_DECLARE(name, knob, unit, values, description) \
  std::optional<PairCase> name(Random& random, double value);
MANIFUZZ_SWEEPS(MANIFUZZ_DECLARE)
#undef MANIFUZZ_DECLARE

}  // namespace manifuzz::turn
